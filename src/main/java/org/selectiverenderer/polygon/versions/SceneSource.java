package org.selectiverenderer.polygon.versions;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.Gzip;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.SceneElement;
import org.selectiverenderer.x3d.SceneText;
import org.selectiverenderer.x3d.X3dFile;
import org.selectiverenderer.x3d.X3dReader;

/** A scene's file, as text and as nodes, and which element is which node. */
final class SceneSource {
  private final boolean compressed;
  private final SceneText text;
  private final X3dFile file;
  private final Map<Location, ParsedNode> nodes = new HashMap<>();

  private SceneSource(boolean compressed, SceneText text, X3dFile file) {
    this.compressed = compressed;
    this.text = text;
    this.file = file;
    file.nodes().forEach(this::map);
  }

  /**
   * @throws BadSceneException if it cannot be changed without harm, with one line that names it
   * @throws IOException if it cannot be read, likewise
   */
  static SceneSource read(Path path, X3dReader reader, Problems problems) throws IOException {
    if (Files.isDirectory(path)) {
      throw new IOException(path + ": this is a folder, not a scene");
    }
    byte[] bytes;
    try {
      bytes = Files.readAllBytes(path);
    } catch (NoSuchFileException e) {
      throw new IOException(path + ": there is no such file", e);
    }
    return of(path, bytes, reader, problems);
  }

  /** The same of a scene that is open in an editor. */
  static SceneSource of(Path path, byte[] bytes, X3dReader reader, Problems problems)
      throws IOException {
    boolean compressed = Gzip.compressed(bytes);
    byte[] plain = compressed ? unpacked(path, bytes) : bytes;
    SceneText text = changeable(path, plain);
    return new SceneSource(compressed, text, reader.read(path.toString(), plain, problems));
  }

  private static byte[] unpacked(Path path, byte[] bytes) throws IOException {
    try {
      return Gzip.unpacked(bytes);
    } catch (IOException e) {
      throw new IOException(path + ": " + e.getMessage(), e);
    }
  }

  private void map(ParsedNode node) {
    if (nodes.putIfAbsent(node.location(), node) != null) {
      return;
    }
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.given(field.index()) ? node.value(field.index()) : null;
      if (value instanceof ParsedNode child) {
        map(child);
      } else if (value instanceof List<?> list) {
        list.forEach(child -> map((ParsedNode) child));
      }
    }
  }

  SceneText text() {
    return text;
  }

  X3dFile file() {
    return file;
  }

  /** The node that an element stands for; null for ROUTE, USE and the like. */
  @Nullable NodeView node(SceneElement element) {
    return element.attribute("USE").isPresent()
        ? file.named().get(element.attribute("USE").get())
        : nodes.get(element.location());
  }

  private static SceneText changeable(Path path, byte[] plain) throws IOException {
    try {
      return SceneText.of(path.toString(), plain);
    } catch (IOException e) {
      throw new BadSceneException(e);
    }
  }

  /** The file's bytes with another text, compressed if it was. */
  byte[] bytes(String changed) {
    byte[] plain = text.bytes(changed);
    return compressed ? Gzip.packed(plain) : plain;
  }
}
