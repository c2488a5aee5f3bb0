package org.selectiverenderer.scenes;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.selectiverenderer.x3d.write.X3dWriter;

/** The files in {@code inlineNodes/} that come from recipes: file name to text. */
final class GeneratedInlineFiles {

  private GeneratedInlineFiles() {}

  static Map<String, String> all() {
    Map<String, String> files = new TreeMap<>();
    put(files, "woodenFloor.x3d", "Floor boards, 5.2 m by 5.5 m", WoodenFloor::write);
    put(files, "contactShadow.x3d", "Soft shadow on a floor, radius 1", ContactShadow::write);
    return files;
  }

  private static void put(
      Map<String, String> files, String name, String description, Consumer<X3dWriter> recipe) {
    X3dWriter out = new X3dWriter().file("Interchange", "3.3").open("head");
    out.meta("title", name).meta("description", description);
    out.meta("generator", "src/test/java/org/selectiverenderer/scenes").meta("license", "MIT");
    recipe.accept(out.close().open("Scene"));
    files.put(name, out.finish());
  }
}
