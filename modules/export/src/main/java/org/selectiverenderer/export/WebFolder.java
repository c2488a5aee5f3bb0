package org.selectiverenderer.export;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.url.UrlRelativizer;

/**
 * A folder that any web server shows as a page: the page itself, {@code scene.json} which tells it
 * what to show, and the exported scene below {@code scene}, its texts compressed, as most servers
 * do not compress files of these types themselves.
 *
 * @param page the files of the page and of X_ITE
 * @param scene the scene and its files
 * @param plainBytes the bytes of the scene's texts before they were compressed
 */
public record WebFolder(List<PackagedFile> page, List<PackagedFile> scene, long plainBytes) {
  private static final Path SCENE = Path.of("scene");

  /** The file name endings of scenes as text, and those of their compressed form (X3D 19776-1). */
  private static final Map<String, String> COMPRESSED =
      Map.of(".x3d", ".x3dz", ".x3dv", ".x3dvz", ".wrl", ".wrz");

  public WebFolder {
    page = List.copyOf(page);
    scene = List.copyOf(scene);
  }

  /** Returns the bytes of the scene and its files. */
  public long sceneBytes() throws IOException {
    return bytes(scene);
  }

  /** Returns the bytes of the page that every visitor loads. */
  public long pageBytes() throws IOException {
    return bytes(page.stream().filter(file -> !WebPage.part(file)).toList());
  }

  /** Returns the bytes of X_ITE's parts that only some scenes need, such as fonts. */
  public long partBytes() throws IOException {
    return bytes(page.stream().filter(WebPage::part).toList());
  }

  private static long bytes(List<PackagedFile> files) throws IOException {
    long sum = 0;
    for (PackagedFile file : files) {
      sum += file.size();
    }
    return sum;
  }

  /**
   * Puts the page around a scene that was exported with {@link #name} for its files.
   *
   * @param condition the condition that the page begins with, unless its address names another
   * @param seed the random seed of the condition {@code random}
   * @return empty if this program was built without the page
   * @throws IOException if a file cannot be read, with a sentence
   */
  public static Optional<WebFolder> around(ExportedScene exported, Condition condition, int seed)
      throws IOException {
    Optional<WebPage> page = WebPage.load();
    if (page.isEmpty()) {
      return Optional.empty();
    }
    List<PackagedFile> scene = new ArrayList<>();
    List<PackagedFile> sources = new ArrayList<>(List.of(exported.files().scene()));
    sources.addAll(exported.files().files());
    long plain = 0;
    for (PackagedFile file : sources) {
      Path target = SCENE.resolve(file.target());
      if (COMPRESSED.containsValue(ending(file.target()))) {
        byte[] bytes = bytes(file);
        plain += bytes.length;
        byte[] packed = Gzip.compressed(bytes) ? bytes : Gzip.packed(bytes);
        scene.add(new PackagedFile(target, file.source(), Optional.of(packed)));
      } else {
        scene.add(new PackagedFile(target, file.source(), file.changed()));
      }
    }
    List<PackagedFile> files = new ArrayList<>(page.get().files());
    files.add(description(exported, condition, seed, scene));
    return Optional.of(new WebFolder(files, scene, plain));
  }

  /** Returns the name of a scene's file in the folder: one of text tells that it is compressed. */
  public static String name(String name) {
    String compressed = COMPRESSED.get(ending(Path.of(name)));
    return compressed == null ? name : name.substring(0, name.lastIndexOf('.')) + compressed;
  }

  private static String ending(Path file) {
    String name = String.valueOf(file.getFileName());
    int dot = name.lastIndexOf('.');
    return dot < 1 ? "" : name.substring(dot).toLowerCase(Locale.ROOT);
  }

  private static byte[] bytes(PackagedFile file) throws IOException {
    return file.changed().isPresent() ? file.changed().get() : InputFileReader.bytes(file.source());
  }

  /** Returns scene.json, as web/src/page/description.ts reads it. */
  private static PackagedFile description(
      ExportedScene exported, Condition condition, int seed, List<PackagedFile> scene)
      throws IOException {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("title", exported.title());
    json.put("file", url(scene.get(0)));
    json.put("controller", exported.controller().orElseThrow());
    json.put("condition", condition.spelling());
    json.put("seed", seed);
    ObjectNode files = json.putObject("files");
    for (PackagedFile file : scene) {
      files.put(url(file), file.size());
    }
    Path name = Path.of("scene.json");
    byte[] text = JsonWriter.of(json).getBytes(StandardCharsets.UTF_8);
    return new PackagedFile(name, name, Optional.of(text));
  }

  private static String url(PackagedFile file) {
    return UrlRelativizer.between(Path.of(""), file.target());
  }
}
