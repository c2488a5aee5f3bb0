package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.io.BufferedWriter;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EmptyStackException;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.Consumer;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTree;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix.Place;
import org.selectiverenderer.bench.ManySwitchesSceneGenerator;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.DisplaySettling;
import org.selectiverenderer.testing.robot.GuiRobot;

/**
 * Measures how long big scenes keep the author waiting and writes the figures of docs/enricher.md
 * into a file. Judges nothing: figures are the machine's.
 *
 * <p>{@code mvn test -Dtest=SpeedMeasurementTest -Denricher.speed=target/enricher-speed.txt}
 */
@ShowsWindows
@EnabledIfSystemProperty(named = "enricher.speed", matches = ".+")
class SpeedMeasurementTest {
  private static final int RUNS = 5;
  private static final int SETTLING = 1200;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final Stopwatch edt = new Stopwatch();
  private EnricherWindow window;

  /** Counts the processor time of the longest single event; the machine may be busy otherwise. */
  private static final class Stopwatch extends EventQueue {
    private volatile double longest;

    @Override
    protected void dispatchEvent(AWTEvent event) {
      long begun = cpu();
      try {
        super.dispatchEvent(event);
      } finally {
        longest = Math.max(longest, (cpu() - begun) / 1e6);
      }
    }

    private static long cpu() {
      return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    void remove() {
      try {
        pop();
      } catch (EmptyStackException e) {
        throw new IllegalStateException("the queue was never pushed", e);
      }
    }
  }

  @Test
  void bigScenes() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Schemas\n");
    Path report = Path.of(System.getProperty("enricher.speed"));
    Toolkit.getDefaultToolkit().getSystemEventQueue().push(edt);
    try (BufferedWriter out = Files.newBufferedWriter(report)) {
      window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
      hands.show(window.frame());
      open(Path.of("scenes/apartment.x3d").toAbsolutePath()); // classes are loaded
      measure(big(), out);
      measure(plain(), out);
      ManySwitchesSceneGenerator.write(folder.resolve("many"), 10_000, 10);
      measure(folder.resolve("many/scene.x3d"), out);
      GuiRobot.onEdt(
          () -> {
            window.dispose();
            return true;
          });
    } finally {
      edt.remove();
    }
  }

  private double open(Path scene) {
    long begun = System.nanoTime();
    GuiRobot.onEdt(
        () -> {
          window.open(scene);
          return true;
        });
    hands.await(
        "the tree",
        () -> window.session().filter(open -> open.file().path().equals(scene)).isPresent());
    int rows =
        GuiRobot.onEdt(
            GuiRobot.named(window.frame(), "Nodes of the scene", JTree.class)::getRowCount);
    assertThat(rows).isPositive();
    return (System.nanoTime() - begun) / 1e6;
  }

  private void measure(Path scene, BufferedWriter out) throws IOException {
    double opened = open(scene);
    EnricherSession session = window.session().orElseThrow();
    out.write(
        String.format(
            Locale.ROOT,
            "%s (%.1f MB): usable tree after %.0f ms%n",
            folder.relativize(scene),
            Files.size(scene) / 1e6,
            opened));
    JTabbedPane tabs = GuiRobot.named(window.frame(), "Views of the scene", JTabbedPane.class);
    for (String tab : List.of("Preview", "Schemas", "Source")) {
      GuiRobot.onEdt(
          () -> {
            tabs.setSelectedIndex(tabs.indexOfTab(tab));
            return true;
          });
      times(out, tab + ": select", run -> session.select(node(run).element(), this));
      times(out, tab + ": edit", run -> edit(session, run));
      times(out, tab + ": undo", run -> window.undo());
    }
    GuiRobot.onEdt(
        () -> {
          tabs.setSelectedIndex(tabs.indexOfTab("Schemas"));
          return true;
        });
    JTable table = GuiRobot.named(window.frame(), "Degrees of objects by schemas", JTable.class);
    times(out, "select all cells", run -> table.selectAll());
    times(out, "fill a column", run -> fill(session, run));
    times(out, "undo it", run -> window.undo());
    out.flush();
  }

  private EnrichedSwitch node(int run) {
    return window.session().orElseThrow().enrichment().switches().get(5 * run);
  }

  private void edit(EnricherSession session, int run) {
    EnrichedSwitch node = node(run);
    session.perform(
        session.edits().choice(node, 0, node.values().get(0).with(List.of("schema" + run % 3))));
  }

  private static void fill(EnricherSession session, int run) {
    String schema = "filled" + run;
    ObjectSchemaMatrix table = new ObjectSchemaMatrix(session.enrichment(), List.of(schema));
    List<Place> column = table.objects().stream().map(each -> new Place(each, schema)).toList();
    session.perform(table.fill(column, ConsistencyDegree.of("high").orElseThrow()));
  }

  private void times(BufferedWriter out, String name, Consumer<Integer> work) throws IOException {
    List<Double> times = new ArrayList<>();
    for (int run = 0; run < RUNS; run++) {
      int now = run;
      GuiRobot.onEdt(() -> edt.longest = 0);
      GuiRobot.onEdt(
          () -> {
            work.accept(now);
            return true;
          });
      DisplaySettling.pause(
          SETTLING); // all that follows is done: previews, checks, copies for a crash
      times.add(GuiRobot.onEdt(() -> edt.longest));
    }
    double first = times.get(0);
    times.sort(null);
    out.write(
        String.format(
            Locale.ROOT,
            "  %-20s first %6.1f ms, median %6.1f ms%n",
            name,
            first,
            times.get(RUNS / 2)));
  }

  /** 30 MB of geometry in 92 objects. */
  private Path big() throws IOException {
    Path scene = folder.resolve("big.x3d");
    Random random = new Random(1);
    try (BufferedWriter out = Files.newBufferedWriter(scene)) {
      out.write("<X3D profile='Immersive' version='4.0'>\n  <Scene>\n");
      for (int object = 0; object < 92; object++) {
        out.write("    <Switch DEF='Switch_Object%d' whichChoice='0'>\n".formatted(object));
        shape(out, 82, random);
        shape(out, 20, random);
        out.write("    </Switch>\n");
      }
      out.write("  </Scene>\n</X3D>\n");
    }
    return scene;
  }

  private static void shape(BufferedWriter out, int size, Random random) throws IOException {
    out.write("      <Shape><IndexedFaceSet coordIndex='");
    for (int i = 0; i < size * size; i++) {
      int at = i / size * (size + 1) + i % size;
      out.write("%d %d %d %d -1%s".formatted(at, at + 1, at + size + 2, at + size + 1, end(i)));
    }
    out.write("'><Coordinate point='");
    for (int i = 0; i < (size + 1) * (size + 1); i++) {
      out.write(
          String.format(
              Locale.ROOT,
              "%.5f %.5f %.5f%s",
              i / (size + 1) * 0.01,
              random.nextDouble() * 0.01,
              i % (size + 1) * 0.01,
              end(i)));
    }
    out.write("'/></IndexedFaceSet></Shape>\n");
  }

  private static String end(int number) {
    return number % 20 == 19 ? "\n" : " ";
  }

  /** 10,000 Switches of which nothing is said yet. */
  private Path plain() throws IOException {
    Path scene = folder.resolve("plain.x3d");
    try (BufferedWriter out = Files.newBufferedWriter(scene)) {
      out.write("<X3D profile='Immersive' version='4.0'>\n  <Scene>\n");
      for (int i = 0; i < 10_000; i++) {
        out.write(
            """
                <Transform translation='%d 0 %d'>
                  <Switch DEF='Switch_Object%d' whichChoice='0'>
                    <Shape><Box size='0.5 0.5 0.5'/></Shape>
                    <Shape><Box size='0.4 0.4 0.4'/></Shape>
                  </Switch>
                </Transform>
            """
                .formatted(i % 100, i / 100, i));
      }
      out.write("  </Scene>\n</X3D>\n");
    }
    return scene;
  }
}
