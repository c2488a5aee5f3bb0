package org.selectiverenderer.scenes;

import java.util.Map;
import java.util.TreeMap;

/** The files in {@code inlineNodes/} that come from recipes: file name to text. */
final class InlineNodes {

  private InlineNodes() {}

  static Map<String, String> all() {
    Map<String, String> files = new TreeMap<>();
    files.put(
        "woodenFloor.x3d",
        X3dText.document("WoodenFloor", "Floor boards, 5.2 m by 5.5 m", WoodenFloor.shape()));
    files.put(
        "contactShadow.x3d",
        X3dText.document(
            "ContactShadow", "Soft shadow on a floor, radius 1", ContactShadow.shape()));
    return files;
  }
}
