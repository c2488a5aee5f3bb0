package org.selectiverenderer.models;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.gltf.GltfTranslator;
import org.selectiverenderer.models.importer.ImportLimits;
import org.selectiverenderer.models.importer.ModelImportProcess;
import org.selectiverenderer.models.structure.ModelStructureCheck;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.model.ModelFile;
import org.selectiverenderer.x3d.model.ModelTranslator;

/**
 * Translates the models that this module reads: glTF 2.0 in this process, other formats and glTF
 * 1.0 by Assimp in a child process. Found by {@link java.util.ServiceLoader}.
 */
public final class ModelToX3d implements ModelTranslator {
  @Override
  public String x3d(ModelFile model, ProblemCollector problems) throws IOException {
    return switch (model.format()) {
      case GLTF, GLB -> gltf(model, problems);
      case OBJ, STL, PLY, DAE, FBX -> imported(model, problems);
    };
  }

  private static String gltf(ModelFile model, ProblemCollector problems) throws IOException {
    Optional<String> scene = GltfTranslator.x3d(model, problems);
    // Assimp reads glTF 1.0, too
    return scene.isPresent() ? scene.get() : imported(model, problems);
  }

  private static String imported(ModelFile file, ProblemCollector problems) throws IOException {
    ImportLimits limits = ImportLimits.standard();
    ProblemCollector told = new ProblemCollector();
    Optional<String> scene;
    try (ModelImportProcess process = new ModelImportProcess(limits)) {
      scene =
          new ForeignModelReader(
                  NodeCatalogue.load(),
                  file.files(),
                  process,
                  new ModelStructureCheck(limits.maxModelBytes()),
                  told)
              .scene(
                  ModelSource.of(file),
                  file.limits(),
                  "Model in " + file.format().title(),
                  "translated when it was read");
    }
    if (scene.isEmpty()) {
      throw new IOException(
          told.list().stream()
              .map(Problem::message)
              .reduce((first, later) -> later)
              .orElse("the model cannot be read"));
    }
    told.list().forEach(problems::add);
    return scene.get();
  }
}
