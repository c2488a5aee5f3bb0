package org.selectiverenderer.authoring.importing;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Takes the pictures out of the text of a scene, where they are in {@code data:} urls. */
public final class EmbeddedPictures {
  /** The urls of pictures that come from models; base64 is written alike in all encodings. */
  private static final Pattern URL =
      Pattern.compile("data:image/(png|jpeg|webp);base64,([A-Za-z0-9+/]++={0,2})");

  private final Path scene;
  private final Map<String, Path> files = new LinkedHashMap<>();
  private final List<String> faults = new ArrayList<>();
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
      Optional<Path> file = file(stem, matcher.group(1), matcher.group(2));
      String url = file.map(EmbeddedPictures::url).orElse(matcher.group());
      matcher.appendReplacement(taken, Matcher.quoteReplacement(url));
    }
    return matcher.appendTail(taken).toString();
  }

  /** Returns the file of a picture; empty if its data are not base64. */
  private Optional<Path> file(String stem, String type, String data) {
    if (!files.containsKey(data)) {
      byte[] content;
      try {
        content = Base64.getDecoder().decode(data);
      } catch (IllegalArgumentException e) {
        faults.add("a picture in the text is not base64, and stays there: " + e.getMessage());
        return Optional.empty();
      }
      String ending = type.equals("jpeg") ? "jpg" : type;
      Path file = scene.resolveSibling("%s-%d.%s".formatted(stem, files.size() + 1, ending));
      files.put(data, file);
      contents.put(file, content);
    }
    return Optional.ofNullable(files.get(data));
  }

  private static String url(Path file) {
    return String.valueOf(file.getFileName()).replace(" ", "%20");
  }

  /** Returns a sentence for each picture that stays in the text, as it cannot be read. */
  public List<String> faults() {
    return List.copyOf(faults);
  }

  /** Returns the files of the pictures with their contents. */
  public Map<Path, byte[]> contents() {
    return Collections.unmodifiableMap(contents);
  }
}
