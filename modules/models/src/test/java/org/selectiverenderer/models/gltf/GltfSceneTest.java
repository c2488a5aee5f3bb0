package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

/** Reads glTF as scenes for the tests that extend it. */
abstract class GltfSceneTest {
  static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  static final String ONE_NODE =
      "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0%s}],"
          + "\"meshes\":[{\"primitives\":[%s]}]";

  @TempDir Path folder;

  final ProblemCollector problems = new ProblemCollector();

  X3dFile read(String json) throws IOException {
    Path file = Files.writeString(folder.resolve("model.gltf"), json);
    return new X3dReader(CATALOGUE).read(file, problems);
  }

  X3dFile mesh(GltfBuilder gltf, String primitive, String more) throws IOException {
    return read(gltf.json(ONE_NODE.formatted("", primitive) + more));
  }

  static List<ParsedNode> all(X3dFile file, String type) {
    List<ParsedNode> found = new ArrayList<>();
    NodeTraversal.visit(
        file.allNodes(),
        node -> {
          if (node.type().name().equals(type)) {
            found.add(node);
          }
        });
    return found;
  }

  static ParsedNode first(X3dFile file, String type) {
    assertThat(all(file, type)).as(type).isNotEmpty();
    return all(file, type).get(0);
  }

  List<String> messages() {
    return problems.list().stream().map(Problem::message).toList();
  }
}
