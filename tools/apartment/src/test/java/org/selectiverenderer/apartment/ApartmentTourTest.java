package org.selectiverenderer.apartment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** The recorded walk through the apartment that is kept in {@code scenes/}. */
class ApartmentTourTest {
  private final List<Problem> problems = new ArrayList<>();
  private final List<ControlEvent> events = new ArrayList<>();

  /**
   * The polygons of the whole apartment are the sums of thesis Tables 3 to 5 (with the two
   * misprinted ones as recomputed): kitchen 49135, lounge 27729 or 51699, office 67003, 75648,
   * 165608 or 156963.
   */
  @Test
  void theWalkTurnsWhatTheThesisSays() throws IOException {
    List<String> states = walk();

    assertThat(problems).isEmpty();
    assertThat(states)
        .containsExactly(
            "0.00 143867 start of 50",
            "10.73 167837 enter SofaProx [SofaSchema]: AshTray Candle Glass Vase Wine",
            "16.57 143867 exit SofaProx [LoungeSchema]: AshTray Candle Glass Vase Wine",
            "34.68 152512 enter DeskProx [DeskSchema]: Clock FireExtinguisher Plant TrashCan",
            "40.20 242472 enter BookcaseProx [BookcaseSchema]: Laptop LibraryMouse"
                + " LibraryPencilHolder Mug Printer TelephoneLibrary",
            "43.70 233827 exit DeskProx [OfficeSchema]: Clock FireExtinguisher Plant TrashCan",
            "48.73 143867 exit BookcaseProx [OfficeSchema]: Laptop LibraryMouse"
                + " LibraryPencilHolder Mug Printer TelephoneLibrary");
  }

  private List<String> walk() throws IOException {
    CameraPath path =
        CameraPathReader.read(
                Path.of("scenes/paths/apartment-tour.csv"), new ProblemCollector(problems::add))
            .orElseThrow();
    List<String> states = new ArrayList<>();
    try (Walkthrough walk =
        Walkthrough.open(
            Path.of("scenes/apartment.x3d"),
            SelectiveController.Settings.SELECTIVE,
            problems::add,
            event -> events.add(((TimelineEvent.ControllerEvent) event).event()),
            message -> {})) {
      for (int frame = 0; frame <= path.end() * 60; frame++) {
        walk.step(frame / 60.0, new PathMotion(path, 0));
        if (!events.isEmpty()) {
          states.add(
              String.format(Locale.ROOT, "%.2f %d ", frame / 60.0, walk.polygons()) + told());
          events.clear();
        }
      }
    }
    return states;
  }

  /** What happened in one frame, the objects in alphabetical order. */
  private String told() {
    ControlEvent first = events.get(0);
    if (first instanceof ControlEvent.Start start) {
      return "start of " + start.switches().size();
    }
    String area =
        first instanceof ControlEvent.Enter enter
            ? "enter " + enter.sensor() + " " + enter.schemas()
            : "exit "
                + ((ControlEvent.Exit) first).sensor()
                + " "
                + ((ControlEvent.Exit) first).schemas();
    List<String> objects =
        events.stream()
            .filter(ControlEvent.SwitchChange.class::isInstance)
            .map(e -> ((ControlEvent.SwitchChange) e).switchName().replace("Switch_", ""))
            .sorted()
            .toList();
    return area + ": " + String.join(" ", objects);
  }
}
