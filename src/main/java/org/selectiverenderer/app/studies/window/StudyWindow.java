package org.selectiverenderer.app.studies.window;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.WindowConstants;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.enricher.WindowIcon;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.definition.StudyPermissions;
import org.selectiverenderer.swing.BackgroundReader;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.TrustDialog;

/**
 * The window: the studies opened lately, or the open study with its pages; below them one place for
 * what went wrong. For Swing's event thread.
 */
final class StudyWindow {
  private static final int WIDTH = 1100;
  private static final int HEIGHT = 800;
  private static final int[] ICONS = {16, 24, 32, 48, 64, 128};
  private static final String START = "start";
  private static final String STUDY = "study";

  private final JFrame frame = new JFrame(StudyTexts.of("title"));
  private final CardLayout cards = new CardLayout();
  private final JPanel content = new JPanel(cards);
  private final JLabel name = PlainText.only(new JLabel(" "));
  private final JLabel file = PlainText.only(new JLabel(" "));
  private final JTextArea said = new JTextArea();
  private final JScrollPane saying = new JScrollPane(said);
  private final JTabbedPane tabs = new JTabbedPane();
  private final BackgroundReader reader =
      new BackgroundReader("study-reader", StudyTexts.of("closing"));
  private final TrustStore trust;
  private final StudyDesk desk;
  private final StartPage start;
  private final SessionPage session;
  private final Runnable closed;

  /**
   * @param settings folder of the user's settings
   * @param closed called when the window has closed
   */
  StudyWindow(Path settings, Runnable closed) {
    this.closed = closed;
    trust = new TrustStore(settings);
    desk = new StudyDesk(RecentPaths.studies(settings), reader, this::trusted, this::say);
    start = new StartPage(desk, this::choose, this::create);
    session = new SessionPage(desk);
    tab("tab.session", session);
    tab("tab.plan", new PlanPage(desk));
    tab("tab.sessions", new SessionsPage(desk, this::resume));
    tab("tab.rehearsal", new RehearsalPage(desk));
    tab("tab.results", new ResultsPage(desk));
    content.add(start, START);
    content.add(study(), STUDY);
    said.setName("said");
    said.setEditable(false);
    said.setLineWrap(true);
    said.setWrapStyleWord(true);
    said.getAccessibleContext().setAccessibleName(StudyTexts.of("said"));
    saying.setBorder(BorderFactory.createEmptyBorder(6, 12, 8, 12));
    saying.setVisible(false);
    frame.setName("studies");
    frame.setIconImages(Arrays.stream(ICONS).mapToObj(WindowIcon::image).toList());
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            close();
          }
        });
    frame.add(content, BorderLayout.CENTER);
    frame.add(saying, BorderLayout.SOUTH);
    keys();
    desk.listen(this::show);
  }

  private void tab(String key, JPanel page) {
    String text = StudyTexts.of(key);
    page.setName(key);
    tabs.addTab(Mnemonics.without(text), page);
    tabs.setMnemonicAt(tabs.getTabCount() - 1, Mnemonics.code(text));
  }

  private JPanel study() {
    JPanel study = new JPanel(new BorderLayout());
    JPanel head = new JPanel(new MigLayout("insets 10 12 4 12, fillx", "[grow,fill][]", "[][]"));
    name.setName("name");
    file.setName("file");
    name.setFont(name.getFont().deriveFont(Font.BOLD, name.getFont().getSize2D() * 1.3f));
    JButton back = StudyTexts.button("back");
    back.addActionListener(event -> desk.close());
    head.add(name, "wmin 0");
    head.add(back, "spany 2, wrap");
    head.add(file, "wmin 0");
    tabs.setName("tabs");
    study.add(head, BorderLayout.NORTH);
    study.add(tabs, BorderLayout.CENTER);
    return study;
  }

  private void keys() {
    int menu = frame.getToolkit().getMenuShortcutKeyMaskEx();
    key(KeyStroke.getKeyStroke(KeyEvent.VK_O, menu), this::choose);
    key(KeyStroke.getKeyStroke(KeyEvent.VK_N, menu), this::create);
    key(KeyStroke.getKeyStroke(KeyEvent.VK_F5, 0), desk::reload);
  }

  private void key(KeyStroke stroke, Runnable does) {
    frame
        .getRootPane()
        .registerKeyboardAction(event -> does.run(), stroke, JPanel.WHEN_IN_FOCUSED_WINDOW);
  }

  JFrame frame() {
    return frame;
  }

  /** Opens the window, with a study if one is named. */
  void begin(Optional<Path> study) {
    start.reload();
    Rectangle screen = frame.getGraphicsConfiguration().getBounds();
    Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(frame.getGraphicsConfiguration());
    frame.setMinimumSize(new Dimension(640, 480));
    frame.setSize(
        Math.min(WIDTH, screen.width - bars.left - bars.right),
        Math.min(HEIGHT, screen.height - bars.top - bars.bottom));
    frame.setLocationRelativeTo(null);
    frame.setVisible(true);
    study.ifPresent(desk::open);
  }

  private void show(Optional<StudyOverview> study) {
    if (study.isEmpty()) {
      frame.setTitle(StudyTexts.of("title"));
      file.setText(" ");
      tabs.setSelectedIndex(0);
      cards.show(content, START);
      start.reload();
      return;
    }
    Study known = study.get().study();
    boolean fresh = !known.file().toAbsolutePath().toString().equals(file.getText());
    frame.setTitle(PlainText.of(known.name()) + " \u2013 " + StudyTexts.of("title"));
    name.setText(known.name());
    file.setText(known.file().toAbsolutePath().toString());
    cards.show(content, STUDY);
    if (fresh) {
      session.focus();
    }
  }

  /** Shows what went wrong, or what is being done; empty takes it away. */
  private void say(String sentence) {
    said.setText(sentence.strip());
    said.setCaretPosition(0);
    int rows = (int) Math.min(6, Math.max(2, said.getText().lines().count()));
    said.setRows(rows);
    said.setForeground(UIManager.getColor("TextArea.foreground"));
    boolean shown = !said.getText().isEmpty();
    if (saying.isVisible() != shown || shown) {
      saying.setVisible(shown);
      frame.getContentPane().revalidate();
      frame.getContentPane().repaint();
    }
  }

  private void choose() {
    JFileChooser chooser = new JFileChooser();
    chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
    if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
      desk.open(chooser.getSelectedFile().toPath());
    }
  }

  private void create() {
    new NewStudyDialog(frame, desk, desk::open).show();
  }

  private void resume(String participant, int number) {
    tabs.setSelectedComponent(session);
    session.resume(participant, number);
  }

  /** Asks, on the reader's thread, whether a study may have what it asks for. */
  private boolean trusted(Study study) {
    PermissionRequests all = StudyPermissions.of(study);
    if (all.isEmpty() || trust.remembers(all)) {
      return true;
    }
    String place = study.file().toString();
    boolean agreed =
        TrustDialog.ask(
                Optional.of(frame),
                new TrustDialog.Words(
                    StudyTexts.of("title"),
                    StudyTexts.of("trust", place),
                    StudyTexts.of("trust.hint"),
                    StudyTexts.of("trust.yes"),
                    StudyTexts.of("trust.no")),
                all.lines())
            .orElse(false);
    if (!agreed) {
      throw new NotAgreedException(StudyTexts.of("trust.refused", place));
    }
    try {
      trust.remember(all);
    } catch (IOException e) {
      SwingUtilities.invokeLater(() -> say(String.valueOf(e.getMessage())));
    }
    return true;
  }

  /** The user has not agreed to what a study asks for. */
  private static final class NotAgreedException extends RuntimeException {
    private static final long serialVersionUID = 1;

    NotAgreedException(String message) {
      super(message);
    }
  }

  /** Closes the window; a session that was started here goes on, after the user has said so. */
  void close() {
    if (session.live().running()) {
      Object[] answers = {StudyTexts.of("close.yes"), StudyTexts.of("close.no")};
      int answer =
          JOptionPane.showOptionDialog(
              frame,
              StudyTexts.of("close.ask"),
              StudyTexts.of("title"),
              JOptionPane.DEFAULT_OPTION,
              JOptionPane.WARNING_MESSAGE,
              null,
              answers,
              answers[1]);
      if (answer != 0) {
        return;
      }
    }
    session.live().close();
    reader.close();
    frame.dispose();
    closed.run();
  }
}
