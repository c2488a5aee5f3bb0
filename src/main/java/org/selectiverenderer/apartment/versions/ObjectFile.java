package org.selectiverenderer.apartment.versions;

import org.selectiverenderer.modelling.Model;

/**
 * A file in {@code inlineNodes/}.
 *
 * @param name the file's name, {@code trashCan_v1.x3d}
 * @param model what it holds
 */
public record ObjectFile(String name, Model model, String text) {

  public int polygons() {
    return model.polygons();
  }
}
