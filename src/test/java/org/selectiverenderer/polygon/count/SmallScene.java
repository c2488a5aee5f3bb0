package org.selectiverenderer.polygon.count;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.count.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.count.SceneStatistics.StateCount;

/** Writes small scenes. A polygon count n stands for a shape of n triangles. */
final class SmallScene {
  private SmallScene() {}

  static Path write(Path folder, String... content) throws IOException {
    Path file = folder.resolve("scene.x3d");
    Files.writeString(file, document(content));
    return file;
  }

  static String document(String... content) {
    return "<X3D profile='Immersive' version='4.0'><Scene>\n"
        + String.join("\n", content)
        + "\n</Scene></X3D>\n";
  }

  static SceneStatistics count(Path folder, ProblemCollector problems, String... content)
      throws IOException {
    return ScenePolygonCounter.of(write(folder, content), List.of(), problems);
  }

  static String shape(int triangles) {
    return SyntheticApartment.band(triangles);
  }

  /** A Switch that shows its last version; each version is "schemas:triangles". */
  static String object(String def, String... versions) {
    StringBuilder metadata = new StringBuilder("<MetadataSet containerField='metadata'>");
    StringBuilder children = new StringBuilder();
    for (int i = 0; i < versions.length; i++) {
      String[] parts = versions[i].split(":");
      metadata.append(
          String.format(
              Locale.ROOT,
              "<MetadataSet containerField='value'><MetadataString containerField='value'"
                  + " name='degreeOfConsistency' value='\"%s\"'/><MetadataString"
                  + " containerField='value' name='schemaBelonginess' value='\"%s\"'/></MetadataSet>",
              i == versions.length - 1 ? "high" : "low",
              parts[0]));
      children.append(shape(Integer.parseInt(parts[1])));
    }
    return "<Switch DEF='%s' whichChoice='%d'>%s</MetadataSet>%s</Switch>"
        .formatted(def, versions.length - 1, metadata, children);
  }

  /** A sensor of size 2 2 2 around a place on the x axis. */
  static String area(String enter, String exit, double x) {
    return area(enter, exit, "center='" + x + " 0 0' size='2 2 2'");
  }

  static String area(String enter, String exit, String attributes) {
    return """
        <ProximitySensor %s><MetadataSet containerField='metadata'>
        <MetadataString containerField='value' name='enterTimeSchema' value='"%s"'/>
        <MetadataString containerField='value' name='exitTimeSchema' value='"%s"'/>
        </MetadataSet></ProximitySensor>"""
        .formatted(attributes, enter, exit);
  }

  /** "A+B=12" for each state. */
  static List<String> states(ScopeCount scope) {
    return scope.states().stream().map(SmallScene::text).toList();
  }

  private static String text(StateCount state) {
    return String.join("+", state.schemas()) + "=" + state.polygons();
  }
}
