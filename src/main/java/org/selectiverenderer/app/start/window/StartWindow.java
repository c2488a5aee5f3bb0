package org.selectiverenderer.app.start.window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.ImageIcon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.WindowConstants;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.app.start.DocumentsFolder;
import org.selectiverenderer.app.start.Example;
import org.selectiverenderer.app.start.RecentFile;
import org.selectiverenderer.app.start.StartCommands;
import org.selectiverenderer.enricher.WindowIcon;
import org.selectiverenderer.swing.BackgroundReader;
import org.selectiverenderer.swing.PlainText;

/**
 * The window: what the program can do, its examples, what was opened lately; below them one place
 * for what went wrong. For Swing's event thread.
 */
final class StartWindow {
  private static final int[] ICONS = {16, 24, 32, 48, 64, 128};
  private static final int ICON = 48;
  private static final int WIDTH = 880;
  private static final int HEIGHT = 800;
  private static final int MOST_ROWS = 6;
  private static final String EXAMPLES_FOLDER = "Selective Renderer Examples";

  private final JFrame frame = new JFrame(StartTexts.of("title"));
  private final JTextArea said = new JTextArea();
  private final JScrollPane saying = new JScrollPane(said);
  private final JLabel where = PlainText.only(new JLabel(StartTexts.of("examples.none")));
  private final BackgroundReader reader =
      new BackgroundReader("start-reader", StartTexts.of("closing"));
  private final Path settings;
  private final Launcher launcher;
  private final Examples examples;
  private final RecentPanel recent;
  private final JButton open = StartTexts.button("open");
  private final Runnable closed;

  /**
   * @param settings folder of the user's settings
   * @param closed called when the window has closed
   */
  StartWindow(Path settings, Runnable closed) {
    this.settings = settings;
    this.closed = closed;
    launcher = new Launcher(reader, RecentPaths.scenes(settings), this::say);
    examples =
        new Examples(
            reader,
            RecentPaths.exampleFolders(settings),
            (files, bytes) ->
                CopyDialog.ask(
                    frame, DocumentsFolder.ofUser().resolve(EXAMPLES_FOLDER), files, bytes),
            this::say,
            this::reload);
    recent = new RecentPanel(this::open);
    frame.setName("start");
    frame.setIconImages(Arrays.stream(ICONS).mapToObj(WindowIcon::image).toList());
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            close();
          }

          @Override
          public void windowActivated(WindowEvent event) {
            reload();
          }
        });
    frame.setContentPane(content());
    frame
        .getRootPane()
        .registerKeyboardAction(
            event -> choose(),
            KeyStroke.getKeyStroke(
                KeyEvent.VK_O, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx()),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
  }

  private JComponent content() {
    JPanel content =
        new ScrollableColumn(
            new MigLayout(
                "insets 16, fill, wrap 1, hidemode 3",
                "[grow,fill]",
                "[]12[]16[]6[]4[]16[]6[grow,fill]"));
    content.add(head());
    content.add(actions());
    content.add(heading("examples"));
    JPanel cards =
        new JPanel(
            new MigLayout(
                "insets 0, fillx", "[grow,fill,sg]16[grow,fill,sg]16[grow,fill,sg]", "[fill]"));
    for (Example example : Example.values()) {
      cards.add(
          new ExampleCard(
              example,
              () -> examples.open(example, launcher::show),
              () -> examples.open(example, this::enrich)),
          "growx, wmin 100");
    }
    content.add(cards);
    where.setName("examples.where");
    content.add(where, "wmin 0");
    content.add(heading("recent"));
    content.add(recent, "grow, push, hmin 60");
    said.setName("said");
    said.setEditable(false);
    said.setLineWrap(true);
    said.setWrapStyleWord(true);
    said.getAccessibleContext().setAccessibleName(StartTexts.of("said"));
    saying.setVisible(false);
    JScrollPane scrolling = new JScrollPane(content);
    scrolling.setBorder(null);
    JPanel whole = new JPanel(new BorderLayout());
    whole.add(scrolling, BorderLayout.CENTER);
    saying.setBorder(BorderFactory.createEmptyBorder(0, 16, 12, 16));
    whole.add(saying, BorderLayout.SOUTH);
    return whole;
  }

  private static JPanel head() {
    JPanel head = new JPanel(new MigLayout("insets 0, fillx", "[]12[grow,fill]", "[]2[]"));
    JLabel title = new JLabel(StartTexts.of("title"));
    title.setFont(title.getFont().deriveFont(Font.BOLD, title.getFont().getSize2D() * 1.6f));
    head.add(new JLabel(new ImageIcon(WindowIcon.image(ICON))), "spany 2");
    head.add(title, "wrap");
    head.add(StartTexts.paragraph(StartTexts.of("about")), "growx, wmin 100");
    return head;
  }

  private static JLabel heading(String key) {
    JLabel heading = new JLabel(StartTexts.of(key));
    heading.setFont(heading.getFont().deriveFont(Font.BOLD, heading.getFont().getSize2D() * 1.2f));
    return heading;
  }

  private JPanel actions() {
    JPanel actions =
        new JPanel(new MigLayout("insets 0, fillx, wrap 2", "[fill]12[grow,fill]", "[]4[]"));
    action(actions, open, this::choose);
    action(actions, StartTexts.button("enrich"), () -> enrich(Optional.empty()));
    action(
        actions,
        StartTexts.button("studies"),
        () ->
            launcher.start(
                StartCommands.studies(Optional.empty()), StartTexts.of("opening.studies")));
    action(actions, StartTexts.button("doctor"), () -> DoctorDialog.show(frame, launcher));
    return actions;
  }

  private static void action(JPanel actions, JButton button, Runnable does) {
    String about = StartTexts.of(button.getName() + ".about");
    button.addActionListener(event -> does.run());
    button.getAccessibleContext().setAccessibleDescription(about);
    actions.add(button);
    actions.add(StartTexts.paragraph(about), "growx, wmin 100, aligny center");
  }

  /** Opens the window. */
  void begin() {
    reload();
    Rectangle screen = frame.getGraphicsConfiguration().getBounds();
    Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(frame.getGraphicsConfiguration());
    frame.setMinimumSize(new Dimension(520, 420));
    frame.setSize(
        Math.min(WIDTH, screen.width - bars.left - bars.right),
        Math.min(HEIGHT, screen.height - bars.top - bars.bottom));
    frame.getRootPane().setDefaultButton(open);
    frame.setLocationRelativeTo(null);
    frame.setVisible(true);
    open.requestFocusInWindow();
  }

  JFrame frame() {
    return frame;
  }

  private record Lists(List<RecentFile> files, Optional<Path> folder) {}

  private void reload() {
    reader.read(
        () -> new Lists(RecentFile.list(settings), examples.folder()),
        lists -> {
          recent.show(lists.files());
          where.setText(
              lists
                  .folder()
                  .map(folder -> StartTexts.of("examples.where", folder.toString()))
                  .orElse(StartTexts.of("examples.none")));
        },
        this::say);
  }

  private void choose() {
    JFileChooser chooser = new JFileChooser();
    if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
      launcher.show(chooser.getSelectedFile().toPath());
    }
  }

  /** Opens a scene in the enricher. */
  void enrich(Path scene) {
    enrich(Optional.of(scene));
  }

  private void enrich(Optional<Path> scene) {
    launcher.start(StartCommands.enrich(scene), StartTexts.of("opening.enricher"));
  }

  private void open(RecentFile file) {
    if (!file.file().toFile().isFile()) {
      say(StartTexts.of("gone", file.file().toString()));
      reload();
    } else if (file.kind() == RecentFile.Kind.SCENE) {
      launcher.show(file.file());
    } else {
      launcher.start(
          file.command(),
          StartTexts.of(
              file.kind() == RecentFile.Kind.STUDY ? "opening.studies" : "opening.enricher"));
    }
  }

  /** Shows what went wrong, or what is being done; empty takes it away. */
  private void say(String sentence) {
    said.setText(sentence.strip());
    said.setCaretPosition(0);
    said.setRows((int) Math.min(MOST_ROWS, Math.max(2, said.getText().lines().count())));
    saying.setVisible(!said.getText().isEmpty());
    frame.getContentPane().revalidate();
    frame.getContentPane().repaint();
  }

  /** Closes the window; what was started from it goes on. */
  private void close() {
    reader.close();
    frame.dispose();
    closed.run();
  }
}
