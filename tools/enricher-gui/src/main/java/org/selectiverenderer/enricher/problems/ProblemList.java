package org.selectiverenderer.enricher.problems;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.document.DocumentCheck;
import org.selectiverenderer.document.DocumentElement;
import org.selectiverenderer.document.DocumentListener;
import org.selectiverenderer.document.Fault;
import org.selectiverenderer.document.Finding;
import org.selectiverenderer.document.Snapshot;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.Task;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problem;

/**
 * What is wrong with the document: its own findings at once, those of checks of the whole document
 * after a pause, in the background.
 */
public final class ProblemList {
  private static final int PAUSE_MILLISECONDS = 700;

  /** A line of the list. */
  public record Entry(
      Problem problem, Optional<DocumentElement> element, Optional<Finding.Fix> fix) {}

  private final EnricherSession session;
  private final List<DocumentCheck> checks;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final DocumentListener changing = change -> changed();
  private final Timer pause;
  private List<Problem> checked = List.of();
  private List<Entry> entries = List.of();
  private Set<DocumentElement> faulty = Set.of();
  private @Nullable Task checking;

  public ProblemList(EnricherSession session, List<DocumentCheck> checks) {
    this.session = session;
    this.checks = List.copyOf(checks);
    pause = new Timer(PAUSE_MILLISECONDS, event -> check());
    pause.setRepeats(false);
    session.document().addListener(changing);
    collect();
    check();
  }

  /** All, in the order of their places. */
  public List<Entry> entries() {
    return entries;
  }

  /** Whether an element itself has a problem. */
  public boolean faulty(DocumentElement element) {
    return faulty.contains(element);
  }

  /** Hears when the list is another. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void changed() {
    pause.restart();
    collect();
  }

  private void check() {
    if (checking != null) {
      checking.cancel();
    }
    Snapshot snapshot = session.document().snapshot();
    checking =
        session
            .tasks()
            .run(
                "Checking the scene",
                () -> checks.stream().flatMap(check -> check.check(snapshot).stream()).toList(),
                found -> {
                  checked = found;
                  collect();
                },
                failed -> session.message("The scene could not be checked: " + failed));
  }

  private void collect() {
    Map<String, Entry> found = new LinkedHashMap<>();
    session.document().fault().ifPresent(fault -> put(found, entry(fault)));
    if (session.document().fault().isEmpty()) {
      session.enrichment().findings().forEach(finding -> put(found, entry(finding)));
      checked.forEach(problem -> put(found, entry(problem)));
    }
    List<Entry> sorted = new ArrayList<>(found.values());
    sorted.sort(
        Comparator.comparing((Entry each) -> each.problem().severity())
            .thenComparingInt(each -> each.problem().location().line()));
    entries = List.copyOf(sorted);
    faulty = Collections.newSetFromMap(new IdentityHashMap<>());
    entries.stream()
        .filter(each -> each.problem().severity() != Problem.Severity.INFO)
        .flatMap(each -> each.element().stream())
        .forEach(faulty::add);
    listeners.forEach(Runnable::run);
  }

  /** The reader says the same of metadata as the document itself; the one with a fix stays. */
  private static void put(Map<String, Entry> found, Entry entry) {
    found.putIfAbsent(entry.problem().location().line() + ":" + entry.problem().message(), entry);
  }

  private Entry entry(Fault fault) {
    Location at = new Location(session.document().name(), fault.line(), fault.column());
    return new Entry(
        new Problem(Problem.Severity.ERROR, at, fault.message()),
        Optional.empty(),
        Optional.empty());
  }

  private Entry entry(Finding finding) {
    return new Entry(
        finding.located(session.document()), Optional.of(finding.element()), finding.fix());
  }

  private Entry entry(Problem problem) {
    Location at = problem.location();
    Optional<DocumentElement> element =
        at.file().equals(session.document().name()) && at.line() > 0
            ? session
                .document()
                .tree()
                .flatMap(
                    tree -> tree.at(session.document().offset(at.line(), Math.max(1, at.column()))))
            : Optional.empty();
    return new Entry(problem, element, Optional.empty());
  }

  /** Lets go of the session. */
  public void dispose() {
    pause.stop();
    if (checking != null) {
      checking.cancel();
    }
    session.document().removeListener(changing);
  }
}
