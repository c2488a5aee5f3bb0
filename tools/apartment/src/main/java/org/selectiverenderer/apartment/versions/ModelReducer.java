package org.selectiverenderer.apartment.versions;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.ModelWriter;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.models.simplify.Simplifier;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

/** Runs the polygon count process (thesis 4.2) on a file's text. */
final class ModelReducer {
  private static final Path FOLDER = Path.of("");

  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final X3dReader reader = new X3dReader(catalogue);
  private final ModelReader models = new ModelReader(catalogue);
  private final Simplifier simplifier = new Simplifier();
  private final ModelWriter writer = new ModelWriter();

  /**
   * @param title the new file's name
   * @throws IllegalArgumentException if no reduction has exactly this number of polygons
   */
  String reduce(GeneratedFile original, int polygons, String title, String description) {
    Model model = read(original);
    List<Mesh> parts =
        simplifier.simplify(model.meshes(), new SimplificationTarget.Exactly(polygons)).parts();
    if (count(parts) != polygons) {
      // A closed surface has an even count: reduce to one triangle more than asked for, then remove
      // one.
      SimplificationTarget more = new SimplificationTarget.Exactly(polygons + 1);
      parts = BottomFaceRemover.open(simplifier.simplify(model.meshes(), more).parts());
    }
    if (count(parts) != polygons) {
      throw new IllegalArgumentException(
          original.name() + " can be reduced to " + count(parts) + " polygons, not to " + polygons);
    }
    return writer.text(model.with(parts), FOLDER, title, description);
  }

  private static int count(List<Mesh> parts) {
    return parts.stream().mapToInt(Mesh::polygons).sum();
  }

  private Model read(GeneratedFile file) {
    ProblemCollector problems = new ProblemCollector();
    X3dFile scene =
        reader.read(file.name(), file.text().getBytes(StandardCharsets.UTF_8), problems);
    SourceLocation whole = SourceLocation.of(file.name());
    Model model =
        models
            .of(scene.nodes(), scene, FOLDER, whole, file.name(), problems)
            .orElse(new Model(List.of(), List.of()));
    if (problems.any()) {
      throw new IllegalArgumentException(problems.list().get(0).toString());
    }
    return model;
  }
}
