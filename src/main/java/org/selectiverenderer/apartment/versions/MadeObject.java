package org.selectiverenderer.apartment.versions;

import java.util.List;
import org.selectiverenderer.modelling.Model;

/**
 * An object with its files.
 *
 * @param model version 1, or the only one
 * @param files one for each version
 */
public record MadeObject(Model model, List<ObjectFile> files) {
  public MadeObject {
    files = List.copyOf(files);
  }
}
