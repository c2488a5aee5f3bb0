package org.selectiverenderer.authoring.importing;

import java.nio.file.Path;
import java.util.Base64;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Takes the pictures out of the text of a scene, where they are in {@code data:} urls. */
public final class EmbeddedPictures {
  /** The urls of pictures that come from models; base64 is written alike in all encodings. */
  private static final Pattern URL =
      Pattern.compile("data:image/(png|jpeg|webp);base64,([A-Za-z0-9+/]++={0,2})");

  private final Path scene;
  private final Map<String, Path> files = new LinkedHashMap<>();
  private final Map<Path, byte[]> contents = new LinkedHashMap<>();

  /**
   * @param scene the file that the text is written to; the pictures are named after it
   */
  public EmbeddedPictures(Path scene) {
    this.scene = scene;
  }

  /** Returns the text with urls of files beside it. */
  public String takenFrom(String text) {
    String name = String.valueOf(scene.getFileName());
    int dot = name.indexOf('.', 1);
    String stem = dot < 0 ? name : name.substring(0, dot);
    Matcher matcher = URL.matcher(text);
    StringBuilder taken = new StringBuilder();
    while (matcher.find()) {
      String data = matcher.group(2);
      Path file = files.get(data);
      if (file == null) {
        String ending = matcher.group(1).equals("jpeg") ? "jpg" : matcher.group(1);
        file = scene.resolveSibling("%s-%d.%s".formatted(stem, files.size() + 1, ending));
        files.put(data, file);
        contents.put(file, Base64.getDecoder().decode(data));
      }
      matcher.appendReplacement(taken, Matcher.quoteReplacement(url(file)));
    }
    return matcher.appendTail(taken).toString();
  }

  private static String url(Path file) {
    return String.valueOf(file.getFileName()).replace(" ", "%20");
  }

  /** Returns the files of the pictures with their contents. */
  public Map<Path, byte[]> contents() {
    return Collections.unmodifiableMap(contents);
  }
}
