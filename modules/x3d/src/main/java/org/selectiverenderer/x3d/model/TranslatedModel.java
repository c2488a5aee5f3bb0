package org.selectiverenderer.x3d.model;

import java.io.IOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;

/**
 * A model translated by the translator of this distribution.
 *
 * @param text the X3D text; empty if the model is refused
 * @param refused why nothing of it is read; null if it is read
 */
public record TranslatedModel(String text, @Nullable String refused) {
  private static final String END_OF_SCENE = "</Scene>";

  /** Translates a model; what is left out of it is added to the problems. */
  public static TranslatedModel of(ModelFile model, ProblemCollector problems) {
    Optional<ModelTranslator> translator = ModelTranslator.installed();
    if (translator.isEmpty()) {
      return new TranslatedModel(
          "",
          "this is a model in %s, which this distribution of the program does not read; convert it to X3D"
              .formatted(model.format().title()));
    }
    try {
      return new TranslatedModel(overview(translator.get().x3d(model, problems)), null);
    } catch (IOException e) {
      return new TranslatedModel("", String.valueOf(e.getMessage()));
    }
  }

  /**
   * Gives a model without a camera a viewpoint that shows all of it: the default one, 10 m before
   * the origin, is inside of a part in millimetres.
   */
  private static String overview(String x3d) {
    int end = x3d.lastIndexOf(END_OF_SCENE);
    boolean hasCamera = x3d.contains("<Viewpoint") || x3d.contains("<OrthoViewpoint");
    return end < 0 || hasCamera
        ? x3d
        : x3d.substring(0, end) + "  <Viewpoint viewAll='true'/>\n  " + x3d.substring(end);
  }
}
