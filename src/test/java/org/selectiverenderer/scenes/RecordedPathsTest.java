package org.selectiverenderer.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.testing.X3dDocument;
import org.w3c.dom.Element;

/** Where the recorded paths cross the sensors' boxes, computed here from the files' numbers. */
class RecordedPathsTest {

  @Test
  void deskVisitEntersAndLeavesAtTheTimesThatTheManualShows() throws IOException {
    assertThat(crossings("trashcan", "desk-visit"))
        .containsExactly("1.25 enter DeskProx", "3.50 exit DeskProx");
  }

  @Test
  void overlapVisitTakesEveryOrderOfEnteringAndLeaving() throws IOException {
    assertThat(crossings("overlap", "overlap-visit"))
        .containsExactly(
            "1.00 enter DeskProx",
            "2.50 enter BookcaseProx",
            "4.00 exit BookcaseProx",
            "5.50 enter BookcaseProx",
            "7.00 exit DeskProx",
            "8.50 enter DeskProx",
            "10.00 exit DeskProx",
            "11.50 exit BookcaseProx");
  }

  @Test
  void theDeskAreaStandsOnTheFloor() throws IOException {
    X3dDocument scene = X3dDocument.read(Path.of("scenes", "trashcan.x3d"));
    double floor = X3dDocument.numbers(attribute(scene, "Office", "translation"))[1];
    double[][] box = sensorBoxes(scene).get("DeskProx");

    assertThat(box[0]).containsExactly(new double[] {2.835, -1.946, -0.953}, within(0.001));
    assertThat(box[1]).containsExactly(new double[] {8.723, 1.781, 2.496}, within(0.001));
    assertThat(floor).isCloseTo(box[0][1], within(0.001));
    double[] can = X3dDocument.numbers(attribute(scene, "Transform_TrashCan", "translation"));
    can[1] += floor + 0.16;
    assertThat(inside(box, can)).isTrue();
  }

  @Test
  void viewpointsAreAtEyeHeightAndOnlyTheFirstIsOutsideTheDeskArea() throws IOException {
    X3dDocument scene = X3dDocument.read(Path.of("scenes", "trashcan.x3d"));
    double[][] box = sensorBoxes(scene).get("DeskProx");
    double floor = X3dDocument.numbers(attribute(scene, "Office", "translation"))[1];
    double eyeHeight =
        X3dDocument.numbers(scene.elements("NavigationInfo").get(0).getAttribute("avatarSize"))[1];

    List<Boolean> inside = new ArrayList<>();
    for (Element viewpoint : scene.elements("Viewpoint")) {
      double[] eye = X3dDocument.numbers(viewpoint.getAttribute("position"));
      assertThat(eye[1] - floor).isCloseTo(eyeHeight, within(0.001));
      inside.add(inside(box, eye));
    }
    assertThat(inside).containsExactly(false, true, true);
  }

  /** The frames at 60 Hz in which the eye is first inside or first outside again. */
  private static List<String> crossings(String sceneName, String pathName) throws IOException {
    Map<String, double[][]> boxes =
        sensorBoxes(X3dDocument.read(Path.of("scenes", sceneName + ".x3d")));
    List<double[]> rows =
        Files.readAllLines(Path.of("scenes", "paths", pathName + ".csv")).stream()
            .skip(1)
            .map(X3dDocument::numbers)
            .toList();
    List<String> events = new ArrayList<>();
    TreeSet<String> entered = new TreeSet<>();
    double end = rows.get(rows.size() - 1)[0];
    for (int frame = 0; frame / 60.0 <= end; frame++) {
      double t = frame / 60.0;
      double[] eye = eyeAt(rows, t);
      boxes.forEach(
          (sensor, box) -> {
            boolean inside = inside(box, eye);
            if (inside ? entered.add(sensor) : entered.remove(sensor)) {
              events.add("%.2f %s %s".formatted(t, inside ? "enter" : "exit", sensor));
            }
          });
    }
    return events;
  }

  private static double[] eyeAt(List<double[]> rows, double t) {
    int next = 1;
    while (next < rows.size() - 1 && rows.get(next)[0] < t) {
      next++;
    }
    double[] a = rows.get(next - 1);
    double[] b = rows.get(next);
    double u = (t - a[0]) / (b[0] - a[0]);
    return new double[] {
      a[1] + u * (b[1] - a[1]), a[2] + u * (b[2] - a[2]), a[3] + u * (b[3] - a[3])
    };
  }

  private static boolean inside(double[][] box, double[] p) {
    for (int i = 0; i < 3; i++) {
      if (p[i] < box[0][i] || p[i] > box[1][i]) {
        return false;
      }
    }
    return true;
  }

  /** World boxes: low and high corner. The sensors' parents scale and move, none rotates. */
  private static Map<String, double[][]> sensorBoxes(X3dDocument scene) {
    Map<String, double[][]> boxes = new TreeMap<>();
    for (Element sensor : scene.elements("ProximitySensor")) {
      double[] half = X3dDocument.numbers(sensor.getAttribute("size"));
      double[] centre = new double[3];
      for (int i = 0; i < 3; i++) {
        half[i] /= 2;
      }
      for (Element parent = (Element) sensor.getParentNode();
          parent.getTagName().equals("Transform");
          parent = (Element) parent.getParentNode()) {
        double[] move = X3dDocument.numbers(parent.getAttribute("translation"));
        String scale = parent.getAttribute("scale");
        double[] factor = X3dDocument.numbers(scale.isEmpty() ? "1 1 1" : scale);
        for (int i = 0; i < 3; i++) {
          half[i] *= factor[i];
          centre[i] = centre[i] * factor[i] + move[i];
        }
      }
      double[][] box = new double[2][3];
      for (int i = 0; i < 3; i++) {
        box[0][i] = centre[i] - half[i];
        box[1][i] = centre[i] + half[i];
      }
      boxes.put(sensor.getAttribute("DEF"), box);
    }
    return boxes;
  }

  private static String attribute(X3dDocument scene, String def, String name) {
    return scene.def(def).orElseThrow().getAttribute(name);
  }
}
