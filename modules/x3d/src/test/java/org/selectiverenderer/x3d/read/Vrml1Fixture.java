package org.selectiverenderer.x3d.read;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Reads VRML 1.0, whose nodes change a state, as the X3D elements that show the same. */
final class Vrml1Fixture {
  private static final String HEADER = "#VRML V1.0 ascii\n";

  private Vrml1Fixture() {}

  /** Reads a scene whose content starts at the second line. */
  static X3dFile scene(ReaderFixture fixture, String content) {
    return fixture.read(HEADER + content);
  }

  /** Returns the elements of a scene whose content starts at the second line. */
  static XmlDocument document(String content) {
    byte[] bytes = (HEADER + content).getBytes(StandardCharsets.UTF_8);
    try {
      return new X3dReader(NodeCatalogue.load())
          .document("s.wrl", new ByteArrayInputStream(bytes), bytes.length);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns the elements within the scene as XML would have them, a line each. */
  static List<String> lines(String content) {
    List<String> lines = new ArrayList<>();
    for (DocumentElement element : document(content).elements()) {
      StringBuilder line = new StringBuilder();
      int depth = 0;
      for (var at = element.parent(); at.isPresent(); at = at.get().parent()) {
        depth++;
      }
      line.append(" ".repeat(Math.max(0, depth - 2))).append(element.name());
      element
          .attributes()
          .forEach(a -> line.append(' ').append(a.name()).append('=').append(a.text()));
      if (depth > 1) {
        lines.add(line.toString());
      }
    }
    return lines;
  }

  /** Returns the text of a room with every node type. */
  static byte[] room() throws IOException {
    try (InputStream in = Vrml1Fixture.class.getResourceAsStream("vrml1-room.wrl")) {
      return Objects.requireNonNull(in).readAllBytes();
    }
  }
}
