package org.selectiverenderer.models;

import java.io.IOException;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.gltf.GltfTranslator;
import org.selectiverenderer.x3d.model.ModelFile;
import org.selectiverenderer.x3d.model.ModelTranslator;

/** Translates the models that this module reads; found by {@link java.util.ServiceLoader}. */
public final class ModelToX3d implements ModelTranslator {
  @Override
  public String x3d(ModelFile model, ProblemCollector problems) throws IOException {
    return switch (model.format()) {
      case GLTF, GLB -> GltfTranslator.x3d(model, problems);
      default ->
          throw new IOException(
              "this is a model in %s, which is not read as a scene; convert it to glTF"
                  .formatted(model.format().title()));
    };
  }
}
