package org.selectiverenderer.enricher;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.WindowConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.document.DocumentElement;
import org.selectiverenderer.document.DocumentListener;
import org.selectiverenderer.document.file.DocumentFile;
import org.selectiverenderer.document.file.Recovery;
import org.selectiverenderer.enricher.ratings.RatingsDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.RecentFiles;
import org.selectiverenderer.enricher.settings.Settings;
import org.selectiverenderer.enricher.settings.Theme;
import org.selectiverenderer.enricher.task.Tasks;
import org.selectiverenderer.enricher.versions.VersionsDialog;
import org.selectiverenderer.x3d.NodeCatalogue;

/** The window with one document at a time. For the event dispatch thread. */
public final class EnricherWindow {
  private static final String NAME = "Enricher";

  private final Settings settings;
  private final Recovery recovery;
  private final RecentFiles recent;
  private final Runnable closed;
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final Tasks tasks = new Tasks(EventQueue::invokeLater);
  private final JFrame frame = new JFrame(NAME);
  private final StatusBar status = new StatusBar(tasks);
  private final JPanel content = new JPanel(new BorderLayout());
  private final Questions questions;
  private final WindowMenus menus;

  /** Later, when the step is in the history. */
  private final DocumentListener titles = change -> EventQueue.invokeLater(this::refresh);

  private @Nullable Workbench bench;
  private @Nullable Saving saving;

  /**
   * @param folder of the user's settings
   * @param closed hears when the window is gone
   */
  public EnricherWindow(Path folder, Runnable closed) {
    this(themed(folder), folder, closed);
  }

  /** Settings, and what is to be said of reading them. */
  private record Remembered(Settings settings, String complaint) {}

  /** Colours come before the first component is made. */
  private static Remembered themed(Path folder) {
    Settings settings = new Settings(folder);
    String complaint = "";
    try {
      settings.load();
    } catch (IOException e) {
      complaint = String.valueOf(e.getMessage());
    }
    Theme.of(settings.word("theme", "")).apply();
    return new Remembered(settings, complaint);
  }

  private EnricherWindow(Remembered remembered, Path folder, Runnable closed) {
    this.settings = remembered.settings();
    this.recovery = new Recovery(folder.resolve("recovery"));
    this.recent = new RecentFiles(settings);
    this.closed = closed;
    status.say(remembered.complaint());
    questions = new DialogQuestions(frame);
    menus = new WindowMenus(this, settings);
    frame.setJMenuBar(menus.bar());
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
    frame.setTransferHandler(new FileDrop(this::open));
    JLabel welcome =
        new JLabel("Drop an X3D scene here, or press Ctrl+O to open one", SwingConstants.CENTER);
    content.add(welcome, BorderLayout.CENTER);
    frame.add(content, BorderLayout.CENTER);
    frame.add(status.component(), BorderLayout.SOUTH);
    frame.setMinimumSize(new Dimension(640, 420));
    Rectangle screen = frame.getGraphicsConfiguration().getBounds();
    frame.setSize(
        settings.number("window.width", Math.min(1280, screen.width)),
        settings.number("window.height", Math.min(860, screen.height)));
    frame.setLocationRelativeTo(null);
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

  /** What was said last. */
  String said() {
    return status.said();
  }

  /** Opens the window. */
  public void show() {
    frame.setVisible(true);
  }

  /** Offers the documents that a crash has left. */
  public void offerRecovery() {
    try {
      List<Recovery.Kept> found = recovery.found();
      if (!found.isEmpty() && bench == null) {
        Recovery.Kept kept = found.get(0);
        if (questions.reload(
            kept.file()
                + " has unsaved changes from a session that ended unexpectedly. Reload"
                + " brings them back as one step that can be undone.")) {
          load("Recovering " + kept.file().getFileName(), () -> recovery.open(kept));
        } else {
          recovery.forget(kept.file());
        }
      }
    } catch (IOException e) {
      status.say("Unsaved changes of before cannot be looked for: " + e.getMessage());
    }
  }

  void chooseAndOpen() {
    questions.fileToOpen(session().map(session -> session.file().path())).ifPresent(this::open);
  }

  /** Opens a scene in place of the one that is open, which the author may save first. */
  public void open(Path path) {
    if (mayLeave()) {
      load("Opening " + path.getFileName(), () -> DocumentFile.open(path));
    }
  }

  private void load(String name, Callable<DocumentFile> opening) {
    tasks.run(
        name, opening, this::adopt, failed -> questions.tell(String.valueOf(failed.getMessage())));
  }

  private void adopt(DocumentFile file) {
    letGo();
    EnricherSession session = new EnricherSession(file, catalogue, tasks, status::say);
    Workbench opened =
        new Workbench(session, settings, recovery, status::count, this::makeVersions);
    bench = opened;
    saving = new Saving(session, questions);
    session.document().addListener(titles);
    content.removeAll();
    content.add(opened.component(), BorderLayout.CENTER);
    content.revalidate();
    frame.validate();
    opened.layOut(content.getWidth(), content.getHeight());
    recent.add(file.path());
    status.say("Opened " + file.path());
    refresh();
  }

  private void letGo() {
    if (bench != null) {
      bench.remember();
      bench.session().document().removeListener(titles);
      bench.dispose();
      bench = null;
      saving = null;
    }
  }

  private boolean mayLeave() {
    if (bench == null || saving == null) {
      return true;
    }
    bench.commit();
    boolean leave = saving.mayClose(menus.reviews());
    if (leave) {
      bench.autosave().forget();
    }
    return leave;
  }

  void save() {
    if (bench != null && saving != null) {
      bench.commit();
      if (saving.save(menus.reviews())) {
        bench.autosave().forget();
      }
      refresh();
    }
  }

  void saveAs() {
    if (bench != null && saving != null) {
      bench.commit();
      Path before = bench.session().file().path();
      if (saving.saveAs()) {
        try {
          recovery.forget(before);
        } catch (IOException e) {
          status.say(String.valueOf(e.getMessage()));
        }
        recent.add(bench.session().file().path());
      }
      refresh();
    }
  }

  void undo() {
    if (bench != null) {
      bench.commit();
      bench.session().document().history().undo();
      refresh();
    }
  }

  void redo() {
    if (bench != null) {
      bench.commit();
      bench.session().document().history().redo();
      refresh();
    }
  }

  void importRatings() {
    session()
        .ifPresent(
            session -> {
              commit();
              new RatingsDialog(frame, session).setVisible(true);
            });
  }

  /** Makes versions of the object that the selection is or is part of. */
  void makeVersions() {
    session()
        .flatMap(EnricherSession::selection)
        .flatMap(EnricherWindow::object)
        .ifPresentOrElse(
            this::makeVersions,
            () -> status.say("Choose an object with a DEF name first, then make versions of it"));
  }

  private void makeVersions(DocumentElement object) {
    commit();
    if (bench != null && object.attached()) {
      new VersionsDialog(frame, bench.session(), object).setVisible(true);
      bench.lookAtFilesAgain();
    }
  }

  private static Optional<DocumentElement> object(DocumentElement element) {
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      if (at.name().equals("Switch")) {
        return Optional.of(at);
      }
    }
    return element.def().map(def -> element);
  }

  private void commit() {
    if (bench != null) {
      bench.commit();
    }
  }

  void use(Theme theme) {
    settings.put("theme", theme.name());
    theme.apply();
  }

  private void lookAtDisk() {
    if (saving != null && bench != null && saving.wantsReload()) {
      Path path = bench.session().file().path();
      load("Reloading " + path.getFileName(), () -> DocumentFile.open(path));
    }
  }

  /** Closes the window, if the author has no unsaved work or does not want it. */
  void close() {
    if (!mayLeave()) {
      return;
    }
    letGo();
    settings.put("window.width", frame.getWidth());
    settings.put("window.height", frame.getHeight());
    try {
      settings.store();
    } catch (IOException e) {
      questions.tell("The layout cannot be remembered: " + e.getMessage());
    }
    dispose();
  }

  /** Closes the window whatever is unsaved. */
  void dispose() {
    letGo();
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
