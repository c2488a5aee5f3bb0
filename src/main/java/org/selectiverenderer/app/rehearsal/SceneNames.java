package org.selectiverenderer.app.rehearsal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.session.FileChecksumCalculator;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * The named nodes of a scene and of all files that it inlines.
 *
 * @param all the DEFs of all nodes
 * @param viewpoints the DEFs of the nodes from which a scene is seen
 * @param switches the number of choices of each Switch, by DEF
 */
record SceneNames(Set<String> all, Set<String> viewpoints, Map<String, Integer> switches) {
  /**
   * Reads the names.
   *
   * @throws IOException if the scene cannot be read
   */
  static SceneNames of(Path scene, ContentAccessPolicy access) throws IOException {
    SceneNames names = new SceneNames(new HashSet<>(), new HashSet<>(), new HashMap<>());
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    for (String name : FileChecksumCalculator.ofScene(scene, access).keySet()) {
      if (name.matches("(?i).*\\.(png|jpe?g|gif)")) {
        continue;
      }
      Path file = scene.toAbsolutePath().getParent().resolve(name).normalize();
      // What is wrong with the files is told when the scene is loaded as a session loads it.
      NodeTraversal.visit(reader.read(file, new ProblemCollector()).nodes(), names::add);
    }
    return names;
  }

  private void add(ParsedNode node) {
    String name = node.name();
    if (name == null) {
      return;
    }
    all.add(name);
    if (node.type().name().endsWith("Viewpoint")) {
      viewpoints.add(name);
    }
    if (node.type().name().equals("Switch")) {
      switches.put(name, node.nodes("children").size());
    }
  }
}
