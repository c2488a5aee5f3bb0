package org.selectiverenderer.export;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

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
   * Puts the page around a scene that was exported with {@link WebScene#name} for its files.
   *
   * @param condition the condition that the page begins with, unless its address names another
   * @param seed the random seed of the condition {@code random}
   * @return empty if this program was built without the page
   * @throws IOException if a file cannot be read, with a sentence
   */
  public static Optional<WebFolder> around(ExportedScene exported, Condition condition, int seed)
      throws IOException {
    Optional<WebPage> page = WebPage.ofScene();
    if (page.isEmpty()) {
      return Optional.empty();
    }
    PackagedFile main = exported.files().scene();
    LaterVersions later =
        exported.controller().isPresent()
            ? LaterVersions.of(main, condition, seed, NodeCatalogue.load())
            : LaterVersions.none(main);
    WebScene scene = WebScene.of(exported, later.scene(), SCENE);
    List<PackagedFile> files = new ArrayList<>(page.get().files());
    files.add(description(scene, later, exported.title(), condition, seed));
    return Optional.of(new WebFolder(files, scene.files(), scene.plainBytes()));
  }

  /** Returns scene.json, as web/src/page/description.ts reads it. */
  private static PackagedFile description(
      WebScene scene, LaterVersions later, String title, Condition condition, int seed)
      throws IOException {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("title", title);
    scene.describe(json);
    later.describe(json);
    json.put("condition", condition.spelling());
    json.put("seed", seed);
    Path name = Path.of("scene.json");
    byte[] text = JsonWriter.of(json).getBytes(StandardCharsets.UTF_8);
    return new PackagedFile(name, name, Optional.of(text));
  }
}
