package org.selectiverenderer.enricher;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.WindowConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.UndoHistory;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.RecentFiles;
import org.selectiverenderer.enricher.settings.SettingsTrust;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** The main window, with one open document at a time. For the event dispatch thread. */
final class EnricherWindow {
  private static final String NAME = "Enricher";

  private final EnricherSettings settings;
  private final AppearanceSettings look;
  private final CrashRecovery recovery;
  private final RecentFiles recent;
  private final WindowBoundsStore place;
  private final EnricherWindows windows;
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final TaskExecutor tasks = new TaskExecutor(EventQueue::invokeLater);
  private final JFrame frame = new JFrame(NAME);
  private final StatusBar status = new StatusBar(tasks);
  private final JPanel content = new JPanel(new BorderLayout());
  private final JLabel welcome = new JLabel(Texts.of("window.welcome"), SwingConstants.CENTER);
  private final UserPrompts questions;
  private final SettingsTrust trust;
  private final HelpDialogs help = new HelpDialogs(frame);
  private final DocumentOpener opening;
  private final SceneDialogs dialogs;
  private final RunCommands runs;
  private final SaveCommands saves;
  private final FileCommands files;
  private final ImportCommands imports;
  private final EnricherMenuBar menus;
  private final Runnable removeTypingFilter;

  /**
   * Refreshes title and menus after the edit, when its step is in the undo history. What was said
   * of an action before is no longer so; the edit's own message comes after it.
   */
  private final DocumentListener titles =
      change -> {
        status.say("");
        EventQueue.invokeLater(this::refresh);
      };

  private @Nullable Workbench bench;

  /** The views of the document that is being opened. */
  private @Nullable WorkbenchParts building;

  /**
   * Creates the only window of its own.
   *
   * @param folder of the user's settings
   * @param closed runs when the window is closed
   */
  EnricherWindow(Path folder, Runnable closed) {
    this(new EnricherWindows(folder, ContentAccessPolicy.none(), closed));
  }

  /**
   * Creates one of several windows.
   *
   * @param windows the windows of this process, which share settings and recovery copies
   */
  EnricherWindow(EnricherWindows windows) {
    this.windows = windows;
    this.look = windows.look();
    this.settings = look.settings();
    this.recovery = windows.recovery();
    this.recent = new RecentFiles(settings);
    this.place = new WindowBoundsStore(settings);
    this.trust = new SettingsTrust(windows.trust(), this::askForTrust);
    status.say(look.complaint());
    questions = new DialogUserPrompts(frame);
    saves =
        new SaveCommands(
            questions,
            path -> windows.showOther(path, this),
            this::reviews,
            status::say,
            this::refresh,
            settings);
    opening =
        new DocumentOpener(
            new DocumentOpener.Place(
                this::bench,
                saves,
                this::adopt,
                path -> windows.showOther(path, this),
                this::announce,
                status::say),
            catalogue,
            tasks,
            questions,
            recovery);
    dialogs = new SceneDialogs(frame, this::bench, status::say);
    runs = new RunCommands(frame, this::bench, opening::open, windows::openNew, status::say);
    files = new FileCommands(this, questions);
    imports = new ImportCommands(this, questions);
    menus = new EnricherMenuBar(this, dialogs, runs, settings);
    frame.setJMenuBar(menus.bar());
    menus.moreKeys(frame.getRootPane());
    removeTypingFilter = AcceleratorTypingFilter.install(menus.bar());
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent e) {
            close();
          }

          @Override
          public void windowActivated(WindowEvent e) {
            saves.lookAtDisk(opening::reload);
          }
        });
    EventQueue.invokeLater(() -> WindowIcon.dress(frame)); // Drawing it must not delay the window.
    frame.setTransferHandler(new FileDropHandler(this::dropped));
    content.add(welcome, BorderLayout.CENTER);
    frame.add(content, BorderLayout.CENTER);
    frame.add(status.component(), BorderLayout.SOUTH);
    Rectangle screen = frame.getGraphicsConfiguration().getBounds();
    frame.setMinimumSize(new Dimension(Math.min(640, screen.width), Math.min(420, screen.height)));
    place.restore(frame);
    windows.add(this);
    refresh();
  }

  public JFrame frame() {
    return frame;
  }

  /** The open document; empty for none. */
  public Optional<EnricherSession> session() {
    return Optional.ofNullable(bench).map(Workbench::session);
  }

  Optional<Workbench> bench() {
    return Optional.ofNullable(bench);
  }

  /** Theme, text size and language. */
  AppearanceSettings look() {
    return look;
  }

  /** The save commands, which also ask before unsaved work is lost. */
  SaveCommands saves() {
    return saves;
  }

  /** The commands of the File menu that make and read scenes. */
  FileCommands files() {
    return files;
  }

  /** The commands that make models part of the scene. */
  ImportCommands imports() {
    return imports;
  }

  /** The windows of this process. */
  EnricherWindows windows() {
    return windows;
  }

  /** Whether the window shows a file, or is about to. */
  boolean has(Path file) {
    Path asked = file.toAbsolutePath().normalize();
    return session()
            .filter(open -> open.file().path().toAbsolutePath().normalize().equals(asked))
            .isPresent()
        || opening.reading(asked);
  }

  RecentFiles recent() {
    return recent;
  }

  /** Opens the window. */
  public void show() {
    frame.setVisible(true);
  }

  /**
   * Starts the author's work with a scene, after asking what to do with the unsaved changes of a
   * crashed session.
   */
  public void begin(Optional<Path> scene) {
    scene.ifPresent(recent::add);
    opening.begin(scene);
  }

  /** Opens a scene in place of the open one, which the author may save first. */
  public void open(Path path) {
    opening.open(path, () -> {});
  }

  /** Opens a scene in place of the open one, about whose changes the author has been asked. */
  void openUnasked(Path path) {
    opening.openUnasked(path);
  }

  /** Cancels what runs in the background; returns whether there was anything. */
  boolean cancelTasks() {
    List<BackgroundTask> running = tasks.running();
    running.forEach(BackgroundTask::cancel);
    return !running.isEmpty();
  }

  /** The part that opens scenes. */
  DocumentOpener opening() {
    return opening;
  }

  /**
   * Shows what is being done: in the status bar, or in the middle of the window while no scene is
   * open.
   *
   * @param work a sentence; empty when nothing is being done
   */
  private void announce(String work) {
    status.announced(work);
    String told = work.isEmpty() ? "" : work + "\u2026";
    status.say(bench == null ? "" : told);
    welcome.setText(work.isEmpty() ? Texts.of("window.welcome") : told);
  }

  private void askForTrust(String sentence, List<String> lines, Consumer<Boolean> answer) {
    EventQueue.invokeLater(() -> answer.accept(questions.trust(sentence, lines)));
  }

  private void adopt(DocumentFile file) {
    letGo(true);
    EnricherSession session =
        new EnricherSession(file, catalogue, files.access(file.path()), tasks, status::say);
    WorkbenchParts parts = new WorkbenchParts(session, settings, recovery, trust);
    building = parts;
    refresh();
    parts.make(() -> show(file, parts));
  }

  /** Shows the views that have been made. */
  private void show(DocumentFile file, WorkbenchParts parts) {
    building = null;
    EnricherSession session = parts.session;
    Workbench opened = new Workbench(parts, settings, status::count, dialogs::versions);
    opened.onElsewhere(opening::openElsewhere);
    opened.menu().add(runs.openInlineOfNode());
    bench = opened;
    saves.begin(opened);
    session.document().addListener(titles);
    session.addSelectionListener((element, origin) -> status.say(""));
    content.removeAll();
    content.add(opened.component(), BorderLayout.CENTER);
    FileDropHandler.install(opened.component(), this::dropped);
    content.revalidate();
    frame.validate();
    opened.layOut(content.getWidth(), content.getHeight());
    opened.focus();
    recent.add(file.path());
    opening.opened(file.path());
    status.say(Texts.of("window.opened", file.path()));
    refresh();
  }

  /**
   * @param done whether the unsaved changes may be forgotten
   */
  private void letGo(boolean done) {
    if (building != null) {
      building.dispose();
      building = null;
    }
    if (bench != null) {
      bench.remember();
      if (done) {
        bench.autosave().forget();
      }
      bench.session().document().removeListener(titles);
      bench.dispose();
      bench = null;
      saves.end();
      content.removeAll();
      content.add(welcome, BorderLayout.CENTER);
      content.revalidate();
      content.repaint();
    }
  }

  void undo() {
    step(true);
  }

  void redo() {
    step(false);
  }

  private void step(boolean back) {
    if (bench != null) {
      bench.commit();
      UndoHistory history = bench.session().document().history();
      boolean files = history.concernsFiles(back);
      if (new UndoController(history, questions).go(back) && files) {
        bench.lookAtFilesAgain();
      }
      refresh();
    }
  }

  /**
   * Imports a dropped .csv file as ratings and a file on the preview, the plan or the tree as part
   * of the scene, and opens any other file as a scene; after the drop has ended.
   */
  private void dropped(Path file, Component over, Point at) {
    boolean table = file.toString().toLowerCase(Locale.ROOT).endsWith(".csv");
    EventQueue.invokeLater(
        () -> {
          if (table && bench != null) {
            dialogs.ratings(Optional.of(file));
          } else if (!imports.dropped(file, over, at)) {
            open(file);
          }
        });
  }

  /** Shows a message in the status bar. */
  void say(String sentence) {
    status.say(sentence);
  }

  void showKeys() {
    help.keys();
  }

  void showAbout() {
    help.about(bench().flatMap(Workbench::drawnBy));
  }

  /** Closes the window, unless the author wants to keep working on unsaved changes. */
  void close() {
    saves.leaving(
        () -> {
          letGo(true);
          place.remember(frame);
          try {
            settings.store();
          } catch (IOException e) {
            questions.tell(Texts.of("window.nolayout", String.valueOf(e.getMessage())));
          }
          dispose();
        });
  }

  /**
   * Closes the window without asking; recovery copies of unsaved changes stay for the next start.
   */
  void dispose() {
    letGo(false);
    removeTypingFilter.run();
    runs.dispose();
    status.dispose();
    tasks.close();
    frame.dispose();
    windows.remove(this);
  }

  private boolean reviews() {
    return menus.reviews();
  }

  private void refresh() {
    String title =
        session()
            .map(
                session ->
                    (session.document().modified() ? "● " : "")
                        + session.file().path().getFileName()
                        + " - "
                        + NAME)
            .orElse(NAME);
    frame.setTitle(title);
    menus.refresh();
  }
}
