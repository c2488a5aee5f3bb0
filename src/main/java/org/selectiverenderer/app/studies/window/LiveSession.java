package org.selectiverenderer.app.studies.window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.Timer;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.process.CommandProcess;
import org.selectiverenderer.app.process.ProgramCommand;
import org.selectiverenderer.app.studies.SessionProgress;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * Follows a session by its journal, once a second: its steps, flags and notes, the tracker and the
 * disk. The session may have been started here or elsewhere; only what was started here can be
 * ended here.
 */
final class LiveSession {
  private static final int PERIOD_MS = 1_000;

  /** Most characters of the messages that are kept. */
  private static final int MOST = 50_000;

  private final StudyDesk desk;
  private final Runnable changed;
  private boolean starting;
  private final JPanel panel =
      new JPanel(
          new MigLayout(
              "insets 0, fill, wrap 1, hidemode 3", "[grow,fill]", "[][][][grow,fill][]"));
  private final JLabel head = PlainText.only(new JLabel());
  private final JLabel state = PlainText.only(new JLabel());
  private final JLabel devices = PlainText.only(new JLabel());
  private final JProgressBar bar = new JProgressBar();
  private final DefaultListModel<String> steps = new DefaultListModel<>();
  private final JTextArea messages = new JTextArea();
  private final JButton abort = StudyTexts.button("live.abort");
  private final Timer timer = new Timer(PERIOD_MS, event -> poll());
  private final Map<SessionFolder, CommandProcess> ours = new HashMap<>();
  private final Set<SessionFolder> over = new HashSet<>();
  private @Nullable SessionFolder followed;
  private boolean fresh;
  private boolean polling;

  /**
   * @param changed called when a session that was started here begins or ends
   */
  LiveSession(StudyDesk desk, Runnable changed) {
    this.desk = desk;
    this.changed = changed;
    head.setName("live.head");
    state.setName("live.state");
    devices.setName("live.devices");
    messages.setName("live.messages");
    messages.setEditable(false);
    messages.setLineWrap(true);
    messages.setWrapStyleWord(true);
    messages.getAccessibleContext().setAccessibleName(StudyTexts.of("live.messages"));
    bar.setStringPainted(true);
    abort.addActionListener(event -> abort());
    JList<String> list = PlainText.entries(new JList<>(steps));
    list.setName("live.steps");
    list.getAccessibleContext().setAccessibleName(StudyTexts.of("live.steps"));
    JPanel both = new JPanel(new MigLayout("insets 0, fill", "[35%,fill][65%,grow,fill]"));
    both.add(titled("live.steps", new JScrollPane(list)), "grow, pushy, wmin 120");
    both.add(titled("live.messages", new JScrollPane(messages)), "grow, push, wmin 160");
    panel.add(head);
    panel.add(bar);
    panel.add(state);
    panel.add(both, "grow, push, hmin 90");
    JPanel below = new JPanel(new MigLayout("insets 0, fillx", "[grow,fill][]"));
    below.add(devices, "wmin 0");
    below.add(abort);
    panel.add(below);
    desk.listen(this::show);
    forget();
  }

  private static JComponent titled(String key, JComponent content) {
    JPanel titled = new JPanel(new BorderLayout(0, 4));
    titled.add(new JLabel(StudyTexts.of(key)), BorderLayout.NORTH);
    titled.add(content, BorderLayout.CENTER);
    return titled;
  }

  JComponent view() {
    return panel;
  }

  /** Returns whether a session that was started here runs. */
  boolean running() {
    return starting || !ours.isEmpty();
  }

  /** Starts a session, and follows it. */
  void start(ProgramCommand command, String participant, int number) {
    Optional<StudyOverview> study = desk.study();
    if (study.isEmpty()) {
      return;
    }
    SessionFolder folder = new SessionFolder(study.get().study().folder(), participant, number);
    messages.setText("");
    followed = folder;
    head.setText(StudyTexts.of("live.starting", participant, Integer.toString(number)));
    starting = true;
    fresh = true;
    changed.run();
    desk.start(
        command,
        this::add,
        status -> ended(folder, status),
        process -> {
          starting = false;
          ours.put(folder, process);
          abort.setEnabled(true);
        });
  }

  private void add(String line) {
    messages.append(line + "\n");
    int length = messages.getDocument().getLength();
    if (length > MOST) {
      messages.replaceRange("", 0, length - MOST / 2);
    }
    messages.setCaretPosition(messages.getDocument().getLength());
  }

  private void ended(SessionFolder folder, int status) {
    starting = false;
    ours.remove(folder);
    changed.run();
    if (status != 0 && folder.equals(followed)) {
      head.setText(StudyTexts.of("live.failed", folder.participant()));
    }
    desk.reload();
    poll();
  }

  private void show(Optional<StudyOverview> study) {
    if (study.isEmpty()) {
      timer.stop();
      followed = null;
      forget();
      return;
    }
    SessionFolder now = followed;
    if (now == null || !now.study().equals(study.get().study().folder())) {
      followed =
          study.get().runs().stream()
              .min(
                  Comparator.comparing(SessionFolder::participant)
                      .thenComparing(SessionFolder::number))
              .orElse(null);
      if (followed == null) {
        forget();
      }
    }
    devices(study.get().study(), study.get().free(), List.of());
    timer.start();
  }

  /** Shows that no session runs. */
  private void forget() {
    steps.clear();
    head.setText(StudyTexts.of("live.none"));
    state.setText(" ");
    devices.setText(" ");
    bar.setValue(0);
    bar.setString("");
    messages.setText("");
    abort.setEnabled(false);
  }

  /** What is read once a second. */
  private record Reading(SessionFolder folder, Optional<SessionProgress> progress, long free) {}

  private void poll() {
    Optional<StudyOverview> study = desk.study();
    if (study.isEmpty() || polling) {
      return;
    }
    polling = true;
    SessionFolder folder = followed;
    LoadedStudy material = study.get().material();
    desk.reader()
        .read(
            () -> read(material, folder),
            reading -> {
              polling = false;
              follow(material, reading);
            },
            why -> {
              polling = false;
              state.setText(why);
            });
  }

  private record Read(Optional<Reading> session, long free) {}

  private static Read read(LoadedStudy material, @Nullable SessionFolder folder)
      throws IOException {
    long free = Files.getFileStore(material.study().folder()).getUsableSpace();
    if (folder == null) {
      return new Read(Optional.empty(), free);
    }
    Optional<SessionProgress> progress =
        Files.isRegularFile(folder.journal())
            ? Optional.of(SessionProgress.read(material, folder.journal()))
            : Optional.empty();
    return new Read(Optional.of(new Reading(folder, progress, free)), free);
  }

  private void follow(LoadedStudy material, Read read) {
    SessionFolder now = followed;
    if (desk.study().filter(known -> known.material().equals(material)).isEmpty()) {
      return;
    }
    if (now == null
        || read.session().isEmpty()
        || !read.session().get().folder().equals(now)
        || read.session().get().progress().isEmpty()) {
      devices(material.study(), read.free(), List.of());
      return;
    }
    SessionProgress progress = read.session().get().progress().get();
    boolean reported = over.contains(now);
    show(now, progress);
    devices(material.study(), read.free(), progress.flags());
    boolean ended = progress.state() != SessionProgress.State.BEGUN;
    if (fresh && !ended) {
      fresh = false; // Its participant has a folder now, and a place soon.
      desk.reload();
    }
    if (ended != reported) {
      if (ended) {
        over.add(now);
      } else {
        over.remove(now); // It was resumed.
      }
      desk.reload();
    }
  }

  private void show(SessionFolder folder, SessionProgress progress) {
    String participant = folder.participant();
    String number = Integer.toString(folder.number());
    boolean begun = progress.state() == SessionProgress.State.BEGUN;
    head.setText(
        switch (progress.state()) {
          case BEGUN ->
              progress.paused()
                  ? StudyTexts.of("live.paused", participant, number)
                  : StudyTexts.of("live.running", participant, number, since(progress));
          case FINISHED -> StudyTexts.of("live.finished", participant, number);
          case ABORTED -> StudyTexts.of("live.aborted", participant, number);
          case REFUSED -> StudyTexts.of("live.refused", participant, number);
        });
    bar.setMaximum(progress.steps().size());
    bar.setValue(progress.done());
    bar.setString(
        StudyTexts.of(
            "live.steps.done",
            Integer.toString(progress.done()),
            Integer.toString(progress.steps().size())));
    List<String> lines = progress.steps().stream().map(LiveSession::line).toList();
    if (!lines.equals(Collections.list(steps.elements()))) {
      steps.clear();
      steps.addAll(lines);
    }
    List<String> flags = progress.flags().stream().map(LiveSession::flag).toList();
    state.setText(
        flags.isEmpty()
            ? StudyTexts.of("live.noflags")
            : StudyTexts.of("live.flags", String.join(", ", flags)));
    alarm(state, !flags.isEmpty());
    abort.setEnabled(begun && ours.containsKey(folder));
    abort.setToolTipText(
        begun && !ours.containsKey(folder) ? StudyTexts.of("live.elsewhere") : null);
  }

  private static String since(SessionProgress progress) {
    return progress
        .since()
        .map(begin -> Duration.between(begin, Instant.now()).toMinutes())
        .map(minutes -> Long.toString(Math.max(0, minutes)))
        .orElse("?");
  }

  private static String line(SessionProgress.Step step) {
    String mark =
        switch (step.state()) {
          case DONE -> "\u2713 ";
          case NOW -> "\u25b6 ";
          case OPEN -> "\u2003 ";
        };
    return mark
        + step.id()
        + (step.trials() > 0
            ? " " + StudyTexts.of("live.trials", Integer.toString(step.trials()))
            : "");
  }

  /** Returns the meaning of a flag in the language of the window. */
  static String flag(SessionFlag flag) {
    return StudyTexts.orElse("flag." + flag.spelling(), flag.meaning());
  }

  private void devices(Study study, long free, List<SessionFlag> raised) {
    boolean low = free < StudyOverview.LEAST_FREE;
    String disk =
        StudyTexts.of(
            low ? "disk.low" : "disk.free", String.format(Locale.ROOT, "%.1f", free / 1e9));
    String tracker =
        study.tracker() instanceof TrackerSpec.None
            ? StudyTexts.of("tracker.none")
            : raised.contains(SessionFlag.TRACKER_ABSENT)
                ? StudyTexts.of("tracker.absent")
                : raised.contains(SessionFlag.TRACKER_LOST)
                    ? StudyTexts.of("tracker.lost", study.tracker().toString())
                    : StudyTexts.of("tracker.is", study.tracker().toString());
    devices.setText(tracker + "   " + disk);
    alarm(devices, low || raised.contains(SessionFlag.TRACKER_LOST));
  }

  private static void alarm(JLabel label, boolean on) {
    Color red = UIManager.getColor("Component.error.focusedBorderColor");
    label.setForeground(on && red != null ? red : UIManager.getColor("Label.foreground"));
  }

  private void abort() {
    SessionFolder folder = followed;
    CommandProcess process = folder == null ? null : ours.get(folder);
    if (process == null) {
      return;
    }
    Object[] answers = {StudyTexts.of("live.abort.yes"), StudyTexts.of("live.abort.no")};
    int answer =
        JOptionPane.showOptionDialog(
            panel,
            StudyTexts.of("live.abort.ask"),
            StudyTexts.of("title"),
            JOptionPane.DEFAULT_OPTION,
            JOptionPane.WARNING_MESSAGE,
            null,
            answers,
            answers[1]);
    if (answer == 0) {
      process.end();
    }
  }

  /** Stops following; the session goes on. */
  void close() {
    timer.stop();
  }
}
