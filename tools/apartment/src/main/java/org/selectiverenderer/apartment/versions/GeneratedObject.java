package org.selectiverenderer.apartment.versions;

import java.util.List;
import org.selectiverenderer.modelling.ParametricModel;

/**
 * A generated object with its files.
 *
 * @param model version 1, or the only one
 * @param files one for each version
 */
public record GeneratedObject(ParametricModel model, List<GeneratedFile> files) {
  public GeneratedObject {
    files = List.copyOf(files);
  }
}
