package org.selectiverenderer.x3d.model;

import java.io.IOException;
import java.util.Optional;
import java.util.ServiceLoader;
import org.selectiverenderer.base.problem.ProblemCollector;

/**
 * Translates models of other programs into X3D. Implementations are found by {@link ServiceLoader}.
 * Thread-safe.
 */
public interface ModelTranslator {
  /** Returns the translator of this distribution; empty if it has none. */
  static Optional<ModelTranslator> installed() {
    return ServiceLoader.load(ModelTranslator.class, ModelTranslator.class.getClassLoader())
        .findFirst();
  }

  /**
   * Translates a model into the text of an X3D 4.0 scene in XML, in metres with y upwards.
   *
   * @param problems receives what is left out, with the path in the model where there is one, such
   *     as {@code nodes[3].mesh}
   * @throws IOException if nothing of it can be read, with one sentence without a full stop that
   *     does not name the model
   */
  String x3d(ModelFile model, ProblemCollector problems) throws IOException;
}
