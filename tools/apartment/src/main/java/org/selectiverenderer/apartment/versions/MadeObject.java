package org.selectiverenderer.apartment.versions;

import java.util.List;
import org.selectiverenderer.modelling.ParametricModel;

/**
 * A generated object with its files.
 *
 * @param model version 1, or the only one
 * @param files one for each version
 */
public record MadeObject(ParametricModel model, List<RecipeFile> files) {
  public MadeObject {
    files = List.copyOf(files);
  }
}
