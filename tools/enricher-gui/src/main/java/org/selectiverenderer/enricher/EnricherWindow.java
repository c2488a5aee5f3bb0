package org.selectiverenderer.enricher;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.WindowConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.document.DocumentListener;
import org.selectiverenderer.document.UndoHistory;
import org.selectiverenderer.document.file.DocumentFile;
import org.selectiverenderer.document.file.Recovery;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.FontZoom;
import org.selectiverenderer.enricher.settings.Language;
import org.selectiverenderer.enricher.settings.RecentFiles;
import org.selectiverenderer.enricher.settings.Theme;
import org.selectiverenderer.enricher.task.Tasks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.ContentAccess;

/** The window with one document at a time. For the event dispatch thread. */
final class EnricherWindow {
  private static final String NAME = "Enricher";

  private final EnricherSettings settings;
  private final ContentAccess access;
  private final Recovery recovery;
  private final RecentFiles recent;
  private final WindowPlace place;
  private final Runnable closed;
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final Tasks tasks = new Tasks(EventQueue::invokeLater);
  private final JFrame frame = new JFrame(NAME);
  private final StatusBar status = new StatusBar(tasks);
  private final JPanel content = new JPanel(new BorderLayout());
  private final JLabel welcome = new JLabel(Texts.of("window.welcome"), SwingConstants.CENTER);
  private final Questions questions;
  private final HelpDialogs help = new HelpDialogs(frame);
  private final FontZoom zoom;
  private final KeptWork kept;
  private final ConversionOffer conversion;
  private final SceneDialogs dialogs;
  private final RunCommands runs;
  private final WindowMenus menus;

  /** Later, when the step is in the history. */
  private final DocumentListener titles = change -> EventQueue.invokeLater(this::refresh);

  /** The scene asked for last, and what hears that it is there. */
  private record Awaited(Path path, Runnable opened) {}

  private @Nullable Awaited awaited;

  private @Nullable Workbench bench;
  private @Nullable Saving saving;

  /**
   * @param folder of the user's settings
   * @param closed hears when the window is gone
   */
  public EnricherWindow(Path folder, Runnable closed) {
    this(folder, ContentAccess.none(), closed);
  }

  /**
   * @param folder of the user's settings
   * @param access what scenes may name besides their own files, beside what the settings allow
   * @param closed hears when the window is gone
   */
  public EnricherWindow(Path folder, ContentAccess access, Runnable closed) {
    this(themed(folder, access), folder, closed);
  }

  /** Settings, and what is to be said of reading them. */
  private record Remembered(EnricherSettings settings, ContentAccess access, String complaint) {}

  /** Colours come before the first component is made. */
  private static Remembered themed(Path folder, ContentAccess given) {
    EnricherSettings settings = new EnricherSettings(folder);
    String complaint = "";
    ContentAccess access = given;
    try {
      settings.load();
      access = settings.access().and(given);
    } catch (IOException | IllegalArgumentException e) {
      complaint = String.valueOf(e.getMessage());
    }
    Language.of(settings).apply();
    Theme.of(settings.word("theme", "")).apply();
    FontZoom zoom = new FontZoom(settings);
    if (zoom.percent() != FontZoom.USUAL) {
      zoom.apply();
    }
    return new Remembered(settings, access, complaint);
  }

  private EnricherWindow(Remembered remembered, Path folder, Runnable closed) {
    this.settings = remembered.settings();
    this.access = remembered.access();
    this.zoom = new FontZoom(settings);
    this.recovery = new Recovery(folder.resolve("recovery"));
    this.recent = new RecentFiles(settings);
    this.place = new WindowPlace(settings);
    this.closed = closed;
    status.say(remembered.complaint());
    questions = new DialogQuestions(frame);
    conversion = new ConversionOffer(catalogue, tasks, questions, this::read);
    kept = new KeptWork(recovery, questions, status::say);
    dialogs = new SceneDialogs(frame, this::bench, status::say);
    runs = new RunCommands(frame, this::bench, this::open, status::say);
    menus = new WindowMenus(this, dialogs, runs, settings);
    frame.setJMenuBar(menus.bar());
    menus.moreKeys(frame.getRootPane());
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent e) {
            close();
          }

          @Override
          public void windowActivated(WindowEvent e) {
            lookAtDisk();
          }
        });
    WindowIcon.dress(frame);
    frame.setTransferHandler(new FileDrop(this::dropped));
    content.add(welcome, BorderLayout.CENTER);
    frame.add(content, BorderLayout.CENTER);
    frame.add(status.component(), BorderLayout.SOUTH);
    Rectangle screen = frame.getGraphicsConfiguration().getBounds();
    frame.setMinimumSize(new Dimension(Math.min(640, screen.width), Math.min(420, screen.height)));
    place.restore(frame);
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

  RecentFiles recent() {
    return recent;
  }

  /** Opens the window. */
  public void show() {
    frame.setVisible(true);
  }

  /**
   * Begins the author's work: with a scene, and with the question what is to become of changes that
   * a crash has left.
   */
  public void begin(Optional<Path> scene) {
    scene.ifPresent(recent::add);
    Optional<Questions.Left> answer = kept.offer(this::restore);
    if (!answer.equals(Optional.of(Questions.Left.RESTORE))) {
      scene.ifPresent(this::open);
    }
  }

  /** Asks again what is to become of changes that a crash has left. */
  void askAboutKept() {
    if (kept.offer(this::restore).isEmpty()) {
      questions.tell(Texts.of("window.nokept"));
    }
  }

  private void restore(Recovery.Kept left) {
    leaving(
        () ->
            load(
                Texts.of("window.restoring", left.file().getFileName()),
                () -> recovery.open(left)));
  }

  void chooseAndOpen() {
    questions.fileToOpen(session().map(session -> session.file().path())).ifPresent(this::open);
  }

  /** Opens a scene in place of the one that is open, which the author may save first. */
  public void open(Path path) {
    open(path, () -> {});
  }

  /**
   * @param opened hears that the scene is there
   */
  private void open(Path path, Runnable opened) {
    awaited = new Awaited(path, opened);
    leaving(
        () -> {
          announce(Texts.of("window.opening", path.getFileName()) + "\u2026");
          conversion.open(path, () -> read(path), () -> announce(""));
        });
  }

  private void read(Path path) {
    load(Texts.of("window.opening", path.getFileName()), () -> DocumentFile.open(path));
  }

  private void load(String name, Callable<DocumentFile> opening) {
    announce(name + "\u2026");
    Workbench before = bench;
    long agreed = before == null ? 0 : before.session().document().revision();
    tasks.run(
        name,
        opening,
        file -> {
          if (before != null
              && before == bench
              && before.session().document().revision() != agreed) {
            leaving(() -> adopt(file)); // changed while the other was read
          } else {
            adopt(file);
          }
        },
        failed -> {
          announce("");
          questions.tell(String.valueOf(failed.getMessage()));
        });
  }

  /**
   * Says at once what is going on, where there is nothing else to look at in its middle too.
   *
   * @param work empty when nothing is
   */
  private void announce(String work) {
    status.say(work);
    welcome.setText(work.isEmpty() ? Texts.of("window.welcome") : work);
  }

  private void adopt(DocumentFile file) {
    letGo(true);
    EnricherSession session = new EnricherSession(file, catalogue, access, tasks, status::say);
    Workbench opened = new Workbench(session, settings, recovery, status::count, dialogs::versions);
    opened.onElsewhere(this::openElsewhere);
    opened.menu().add(runs.openInlineOfNode());
    bench = opened;
    saving = new Saving(session, questions);
    session.document().addListener(titles);
    content.removeAll();
    content.add(opened.component(), BorderLayout.CENTER);
    FileDrop.install(opened.component(), this::dropped);
    content.revalidate();
    frame.validate();
    opened.layOut(content.getWidth(), content.getHeight());
    opened.focus();
    recent.add(file.path());
    announce("");
    if (awaited != null && awaited.path().equals(file.path())) {
      awaited.opened().run();
      awaited = null;
    }
    status.say(Texts.of("window.opened", file.path()));
    refresh();
  }

  /**
   * @param done whether what is unsaved is not wanted any more
   */
  private void letGo(boolean done) {
    if (bench != null) {
      bench.remember();
      if (done) {
        bench.autosave().forget();
      }
      bench.session().document().removeListener(titles);
      bench.dispose();
      bench = null;
      saving = null;
    }
  }

  private void leaving(Runnable leave) {
    if (saving == null) {
      leave.run();
    } else {
      commit();
      saving.leaving(menus.reviews(), leave);
    }
  }

  void save() {
    save(menus.reviews());
  }

  private void save(boolean review) {
    if (bench != null && saving != null) {
      Workbench saved = bench;
      commit();
      saving.save(
          review,
          () -> {
            forget(saved, saved.session().file().path());
            refresh();
          });
    }
  }

  void saveAs() {
    if (bench != null && saving != null) {
      Workbench saved = bench;
      commit();
      Path before = saved.session().file().path();
      saving.saveAs(
          () -> {
            forget(saved, before);
            recent.add(saved.session().file().path());
            refresh();
          });
    }
  }

  /** Shows what saving would change, and saves if the author wants it. */
  void showChanges() {
    commit();
    if (session().filter(session -> session.document().modified()).isPresent()) {
      save(true);
    } else {
      status.say(Texts.of("window.unchanged"));
    }
  }

  /** Opens a file of which a problem is, such as an Inline's, in place of the scene. */
  private void openElsewhere(Location place) {
    Path other = Path.of(place.file());
    if (Files.isRegularFile(other)) {
      open(other);
    } else {
      status.say(Texts.of("problems.no.file", place.file()));
    }
  }

  /** Puts together what is open and what another program has made of its file. */
  void merge() {
    if (saving != null) {
      commit();
      saving.merge();
    }
  }

  private static void forget(Workbench saved, Path path) {
    if (!saved.session().document().modified()) {
      saved.autosave().forget(path);
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
      if (new Steps(history, questions).go(back) && files) {
        bench.lookAtFilesAgain();
      }
      refresh();
    }
  }

  /** A table is one of ratings, all else a scene. Later, when the drop has ended. */
  private void dropped(Path file) {
    boolean table = file.toString().toLowerCase(Locale.ROOT).endsWith(".csv");
    EventQueue.invokeLater(
        () -> {
          if (table && bench != null) {
            dialogs.ratings(Optional.of(file));
          } else {
            open(file);
          }
        });
  }

  private void commit() {
    if (bench != null) {
      bench.commit();
    }
  }

  void use(Theme theme) {
    settings.put("theme", theme.name());
    theme.apply();
    zoom.apply();
  }

  /**
   * Makes all letters larger or smaller.
   *
   * @param steps above 0 for larger, below for smaller, 0 for as the system has them
   */
  void zoom(int steps) {
    int percent = steps == 0 ? zoom.reset() : zoom.change(steps);
    status.say(Texts.of("window.zoom", DecimalText.grouped(percent)));
  }

  /** Remembers the language for the next start. */
  void use(Language language) {
    language.choose(settings);
    status.say(Texts.of("window.language", language.title()));
  }

  void showKeys() {
    help.keys();
  }

  void showAbout() {
    help.about(bench().flatMap(Workbench::drawnBy));
  }

  private void lookAtDisk() {
    if (saving != null && bench != null) {
      Path path = bench.session().file().path();
      saving.lookAtDisk(
          () ->
              load(
                  Texts.of("window.reloading", path.getFileName()), () -> DocumentFile.open(path)));
    }
  }

  /** Closes the window, if the author has no unsaved work or does not want it. */
  void close() {
    leaving(
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

  /** Closes the window whatever is unsaved; that stays kept for the next start. */
  void dispose() {
    letGo(false);
    runs.dispose();
    status.dispose();
    tasks.close();
    frame.dispose();
    closed.run();
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
