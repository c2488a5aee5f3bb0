package org.selectiverenderer.enricher;

import static org.selectiverenderer.testing.robot.GuiRobot.onEdt;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryUsage;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.authoring.placement.PlacementEdits;
import org.selectiverenderer.authoring.placement.TransformPose;
import org.selectiverenderer.authoring.structure.StructureEdits;
import org.selectiverenderer.enricher.preview.PreviewImageProbe;
import org.selectiverenderer.enricher.preview.PreviewPanel;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Measures the window with a scene of 30 MB: opening, and edits of each kind. The suite does not
 * run it; docs/performance.md tells how to. {@code -Dbig.bytes=N} takes another size, {@code
 * -Dbig.edits=N} another number of edits.
 */
@ShowsWindows
class BigSceneBenchmark {
  private static final long BYTES = Long.getLong("big.bytes", 30_000_000L);
  private static final int EDITS = Integer.getInteger("big.edits", 20);

  /** Milliseconds between two looks at whether all agree. */
  private static final int LOOK_MS = 5;

  /** Milliseconds between two edits in which the checks after a pause can end. */
  private static final int REST_MS = Integer.getInteger("big.rest", 1500);

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  @TempDir Path folder;
  private final EventClock clock = new EventClock();
  private EnricherWindow window;
  private PreviewPanel preview;

  /** The events of the event dispatch thread since the last {@link #begin}. */
  private static final class EventClock extends EventQueue {
    private final List<double[]> events = new ArrayList<>();
    private int depth;

    @Override
    protected void dispatchEvent(AWTEvent event) {
      long wall = System.nanoTime();
      long cpu = THREADS.getCurrentThreadCpuTime();
      depth++;
      try {
        super.dispatchEvent(event);
      } finally {
        depth--;
        double[] took = {
          (System.nanoTime() - wall) / 1e6, (THREADS.getCurrentThreadCpuTime() - cpu) / 1e6
        };
        if (depth == 0) {
          synchronized (events) {
            events.add(took);
          }
        }
      }
    }

    void begin() {
      synchronized (events) {
        events.clear();
      }
    }

    /** The longest event, by wall clock (0) or processor time (1), in ms. */
    double longest(int which) {
      synchronized (events) {
        return events.stream().mapToDouble(each -> each[which]).max().orElse(0);
      }
    }

    /** The processor time of the five that took most. */
    String most() {
      synchronized (events) {
        return events.stream()
            .sorted((one, other) -> Double.compare(other[1], one[1]))
            .limit(5)
            .map(each -> String.format(Locale.ROOT, "%.0f", each[1]))
            .collect(Collectors.joining(", "));
      }
    }

    long above(double ms) {
      synchronized (events) {
        return events.stream().filter(each -> each[1] > ms).count();
      }
    }
  }

  @Test
  @Timeout(1800)
  void measure() throws Exception {
    Path scene = folder.resolve("big.x3d");
    int objects = BigSceneWriter.write(scene, BYTES);
    System.out.printf("%,d bytes, %d objects%n", Files.size(scene), objects);
    Toolkit.getDefaultToolkit().getSystemEventQueue().push(clock);
    try {
      Path settings = Files.createDirectories(folder.resolve("settings"));
      Files.writeString(settings.resolve("enricher.properties"), "theme=light\n");
      open(settings, scene);
      edits(objects);
      undone();
    } finally {
      onEdt(
          () -> {
            window.dispose();
            return true;
          });
    }
  }

  private void open(Path settings, Path scene) throws InterruptedException {
    clock.begin();
    long from = System.nanoTime();
    window = onEdt(() -> new EnricherWindow(settings, () -> {}));
    onEdt(
        () -> {
          window.show();
          return true;
        });
    onEdt(() -> true);
    event("window, empty", since(from));
    clock.begin();
    long asked = System.nanoTime();
    EventQueue.invokeLater(() -> window.open(scene));
    until(() -> window.session().isPresent());
    event("scene open: text, tree, form", since(asked));
    preview = onEdt(() -> find(window.frame(), PreviewPanel.class));
    until(() -> PreviewImageProbe.revision(preview) >= 0);
    event("first picture", since(asked));
    until(() -> session().tasks().running().isEmpty());
    event("checked", since(asked));
    memory("open");
  }

  private static void event(String what, double whole) {
    System.out.printf(Locale.ROOT, "%-34s %8.0f ms%n", what, whole);
  }

  private static double since(long from) {
    return (System.nanoTime() - from) / 1e6;
  }

  private void memory(String when) {
    System.gc();
    MemoryUsage heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage();
    System.out.printf("memory in use, %s: %d MB%n", when, heap.getUsed() >> 20);
    System.out.printf(
        Locale.ROOT,
        "longest event %.0f ms (%.0f ms CPU), %d above 100 ms CPU, most %s%n",
        clock.longest(0),
        clock.longest(1),
        clock.above(100),
        clock.most());
  }

  private EnricherSession session() {
    return window.session().orElseThrow();
  }

  private DocumentElement object(int number) {
    return session().document().tree().orElseThrow().named("Object_" + number).orElseThrow();
  }

  private void edits(int objects) throws InterruptedException {
    int step = Math.max(1, (objects - 2) / EDITS);
    each("a field's value", i -> field(object(1 + i * step), "1 1 1." + (i + 1)));
    each("rename", i -> rename(object(1 + i * step), "Renamed_" + i));
    each("rename back", i -> rename(named("Renamed_" + i), "Object_" + (1 + i * step)));
    each("move by handle", i -> move(object(1 + i * step), i));
    each("insert", i -> insert(object(1 + i * step), i));
    each("delete", i -> delete("Inserted_" + i));
    each("undo", i -> session().document().history().undo());
    each("redo", i -> session().document().history().redo());
    source();
    each("type in Source", this::type);
    each("half a tag", this::halfTag);
    memory("after edits");
  }

  private DocumentElement named(String def) {
    return session().document().tree().orElseThrow().named(def).orElseThrow();
  }

  private void field(DocumentElement object, String value) {
    session().select(object, this);
    TextEdit change = session().document().layout().attribute(object, "scale", value);
    session().perform(new Edit("Change", List.of(change)));
  }

  private void rename(DocumentElement object, String name) {
    session().select(object, this);
    session().perform(new NodeEdits(session().document()).rename(object, name));
  }

  private void move(DocumentElement object, int by) {
    session().select(object, this);
    Placement at = Placement.of(session().document(), session().catalogue(), object).orElseThrow();
    TransformPose pose =
        new TransformPose(
            new Vector3d(at.pose().translation()).add(0, 0.01 * (by + 1), 0),
            at.pose().center(),
            at.pose().rotation(),
            at.pose().scale(),
            at.pose().scaleOrientation());
    Placement to = new Placement(at.node(), at.transform(), at.parent(), pose);
    session().perform(new PlacementEdits(session().document()).place(List.of(to), "Move"));
  }

  private void insert(DocumentElement object, int number) {
    session().select(object, this);
    String text = "<Transform DEF='Inserted_" + number + "'><Shape><Box/></Shape></Transform>";
    session()
        .perform(
            new StructureEdits(session().document(), session().catalogue())
                .paste(Optional.of(object), text)
                .edit());
  }

  private void delete(String def) {
    DocumentElement node = named(def);
    session().select(node, this);
    session()
        .perform(
            new StructureEdits(session().document(), session().catalogue())
                .remove(List.of(node), "Delete"));
  }

  private void source() throws InterruptedException {
    onEdt(
        () -> {
          Workbench bench = window.bench().orElseThrow();
          bench.showTab(2);
          return true;
        });
    Thread.sleep(REST_MS);
  }

  private void type(int number) {
    RSyntaxTextArea area = find(window.frame(), RSyntaxTextArea.class);
    area.setCaretPosition(area.getText().indexOf("diffuseColor='0.") + 15);
    area.replaceSelection(number % 2 == 0 ? "0" : "00");
    window.bench().orElseThrow().commit();
  }

  /** Types what makes the text not well formed, and takes it away again. */
  private void halfTag(int number) {
    RSyntaxTextArea area = find(window.frame(), RSyntaxTextArea.class);
    int at = area.getText().indexOf("<Appearance>");
    if (number % 2 == 0) {
      area.insert("<Group ", at);
    } else {
      area.replaceRange("", at - "<Group ".length(), at);
    }
    window.bench().orElseThrow().commit();
  }

  private interface Work {
    void run(int number);
  }

  /** Makes edits of one kind, and says how long they and the longest events took. */
  private void each(String kind, Work work) throws InterruptedException {
    double[] whole = new double[EDITS];
    double[] cpu = new double[EDITS];
    double[] wall = new double[EDITS];
    for (int i = 0; i < EDITS; i++) {
      int number = i;
      clock.begin();
      long from = System.nanoTime();
      EventQueue.invokeLater(() -> work.run(number));
      onEdt(() -> true);
      until(this::agree);
      whole[i] = since(from);
      Thread.sleep(REST_MS);
      cpu[i] = clock.longest(1);
      wall[i] = clock.longest(0);
    }
    System.out.printf(
        Locale.ROOT,
        "%-18s whole %5.0f (%5.0f) ms, longest event %4.0f (%4.0f) ms, CPU %4.0f (%4.0f) ms%n",
        kind,
        median(whole),
        most(whole),
        median(wall),
        most(wall),
        median(cpu),
        most(cpu));
  }

  /** Whether text, tree, form and preview show the same state; the first three follow at once. */
  private boolean agree() {
    return !preview.isShowing()
        || session().document().fault().isPresent()
        || PreviewImageProbe.revision(preview) == session().document().revision();
  }

  /** Undoes all, step by step, and says what the steps hold. */
  private void undone() throws InterruptedException {
    int steps = onEdt(() -> session().document().history().names().size());
    long held = onEdt(() -> session().document().history().characters());
    System.out.printf(Locale.ROOT, "%d steps of undo hold %,d characters%n", steps, held);
    long from = System.nanoTime();
    onEdt(
        () -> {
          while (session().document().history().undo()) {
            // all of them
          }
          return true;
        });
    event(steps + " steps undone", since(from));
  }

  private static void until(BooleanSupplier so) throws InterruptedException {
    while (!onEdt(so::getAsBoolean)) {
      Thread.sleep(LOOK_MS);
    }
  }

  private static double median(double[] of) {
    double[] sorted = of.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private static double most(double[] of) {
    return Arrays.stream(of).max().orElse(0);
  }

  private static <T extends Component> T find(Container in, Class<T> type) {
    Deque<Component> left = new ArrayDeque<>(List.of(in));
    while (!left.isEmpty()) {
      Component each = left.remove();
      if (type.isInstance(each)) {
        return type.cast(each);
      }
      if (each instanceof Container more) {
        left.addAll(List.of(more.getComponents()));
      }
    }
    throw new AssertionError("no " + type.getSimpleName());
  }
}
