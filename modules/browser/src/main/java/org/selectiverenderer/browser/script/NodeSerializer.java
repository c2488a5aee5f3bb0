package org.selectiverenderer.browser.script;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.scene.Route;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.write.SceneFormat;
import org.selectiverenderer.x3d.write.X3dNodeWriter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Serialises nodes and scenes in their present state: {@code toXMLString} and {@code toVRMLString}
 * (ISO/IEC 19777-1, 7.3 and 7.4). Prototype instances are written as the nodes of their bodies.
 */
final class NodeSerializer {
  private static final String VERSION = "4.0";

  private NodeSerializer() {}

  /** Writes a node as an element of the XML encoding. */
  static String xml(Node node) {
    X3dWriter out = new X3dWriter();
    append(List.of(node), out);
    return out.finish();
  }

  /** Writes a scene as a file of the XML encoding. */
  static String xml(Scene scene) {
    X3dWriter out = begun(scene.profile(), scene.version());
    scene.meta().forEach(out::meta);
    out.close().open("Scene");
    X3dNodeWriter written = append(scene.root().nodes("children"), out);
    for (Route route : scene.routes()) {
      String from = written.name(route.from());
      String to = written.name(route.to());
      if (!from.isEmpty() && !to.isEmpty()) {
        out.route(
            from, field(route.from(), route.fromField()), to, field(route.to(), route.toField()));
      }
    }
    return out.finish();
  }

  /** Writes a node as a statement of the ClassicVRML encoding. */
  static String classic(Node node, NodeCatalogue catalogue) {
    X3dWriter out = begun("Full", VERSION).close().open("Scene");
    append(List.of(node), out);
    String file = classic(out.finish(), catalogue);
    return file.substring(file.indexOf("\n\n") + 1).strip();
  }

  /** Writes a scene as a file of the ClassicVRML encoding. */
  static String classic(Scene scene, NodeCatalogue catalogue) {
    return classic(xml(scene), catalogue);
  }

  private static X3dWriter begun(String profile, String version) {
    return new X3dWriter()
        .file(profile.isEmpty() ? "Full" : profile, version.isEmpty() ? VERSION : version)
        .open("head");
  }

  private static X3dNodeWriter append(List<Node> nodes, X3dWriter out) {
    X3dNodeWriter text = new X3dNodeWriter(out, X3dNodeWriter.Written.CHANGED);
    nodes.forEach(node -> text.append(PrototypeInstance.body(node), "", (of, url) -> url));
    return text;
  }

  private static String field(Node node, int index) {
    return node.type().fields().get(index).name();
  }

  private static String classic(String xml, NodeCatalogue catalogue) {
    byte[] bytes = xml.getBytes(StandardCharsets.UTF_8);
    try {
      return SceneFormat.CLASSIC.text(
          new X3dReader(catalogue).document("text", new ByteArrayInputStream(bytes), bytes.length),
          catalogue,
          new ProblemCollector());
    } catch (IOException e) {
      throw new UncheckedIOException(e); // Never thrown for bytes in memory.
    }
  }
}
