package org.selectiverenderer.enricher.form;

import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.AWTException;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.JTabbedPane;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.text.JTextComponent;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.enricher.help.HelpPanel;
import org.selectiverenderer.enricher.preview.VersionImageRenderer;
import org.selectiverenderer.enricher.problems.ProblemsPanel;
import org.selectiverenderer.enricher.problems.ValidatorCheck;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.testing.robot.RobotEventSync;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** A window with the form, the help and the problems of a scene, driven by a robot. */
final class FormWindowDriver implements AutoCloseable {
  final EnricherSession session;
  final FormPanel form;
  final HelpPanel help;
  final ProblemsPanel problems;
  final Robot robot;
  final List<String> messages = new ArrayList<>();
  private final TaskExecutor tasks = new TaskExecutor(EventQueue::invokeLater);
  private final VersionImageRenderer pictures = new VersionImageRenderer();
  private final JFrame window;

  FormWindowDriver(Path scene, boolean dark) throws IOException, AWTException {
    DocumentFile file = DocumentFile.open(scene);
    session = get(() -> new EnricherSession(file, NodeCatalogue.load(), tasks, messages::add));
    edt(() -> theme(dark));
    form = get(() -> new FormPanel(session, pictures));
    help = get(() -> new HelpPanel(session));
    ValidatorCheck validator =
        new ValidatorCheck(
            file::path,
            RuleCatalogue.standard(),
            problems -> Optional.of(ValidationSettings.standard()));
    problems = get(() -> new ProblemsPanel(session, List.of(validator)));
    edt(() -> form.follow(problems));
    window = get(this::window);
    robot = new Robot();
    robot.setAutoDelay(5);
  }

  private static void theme(boolean dark) {
    try {
      UIManager.setLookAndFeel(dark ? new FlatDarkLaf() : new FlatLightLaf());
    } catch (UnsupportedLookAndFeelException e) {
      throw new AssertionError(e);
    }
  }

  private JFrame window() {
    JFrame made = new JFrame("Form");
    JTabbedPane side = new JTabbedPane();
    side.add("Help", help);
    made.getContentPane()
        .setLayout(new MigLayout("", "[380!,fill][grow,fill]", "[grow][" + "200!,fill]"));
    made.add(form, "growy");
    made.add(side, "wrap, growy, wmin 0");
    made.add(problems, "span, grow");
    made.setBounds(20, 5, 1000, 990); // the fields of two choices are in view
    made.setVisible(true);
    return made;
  }

  void select(String def) {
    edt(() -> session.select(element(def), this));
  }

  private DocumentElement element(String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  String text(String def) {
    return get(() -> session.document().text(element(def)));
  }

  /** What the form says in sentences. */
  String texts() {
    return get(
        () ->
            all(form)
                .filter(JTextComponent.class::isInstance)
                .map(each -> ((JTextComponent) each).getText())
                .collect(Collectors.joining(" ")));
  }

  /** The component in view that has a name. */
  Component named(String name) {
    return get(
        () ->
            all(window.getContentPane())
                .filter(c -> name.equals(c.getName()))
                .reduce((first, last) -> last)
                .orElseThrow(() -> new AssertionError("no " + name)));
  }

  static Stream<Component> all(Component component) {
    Stream<Component> below =
        component instanceof Container container
            ? Stream.of(container.getComponents()).flatMap(FormWindowDriver::all)
            : Stream.empty();
    return Stream.concat(Stream.of(component), below);
  }

  void click(Component component) {
    Point at = get(component::getLocationOnScreen);
    RobotEventSync.of(
        MouseEvent.MOUSE_RELEASED,
        1,
        () -> {
          robot.mouseMove(at.x + 12, at.y + component.getHeight() / 2);
          robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
          robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        });
  }

  /** Types letters, digits and signs without a modifier, capitals with Shift. */
  void type(String text) {
    for (char c : text.toCharArray()) {
      boolean shift = Character.isUpperCase(c);
      if (shift) {
        robot.keyPress(KeyEvent.VK_SHIFT);
      }
      press(KeyEvent.getExtendedKeyCodeForChar(c));
      if (shift) {
        robot.keyRelease(KeyEvent.VK_SHIFT);
      }
    }
  }

  /** Nothing is waited for while the key is down: the display would repeat it. */
  void press(int key) {
    RobotEventSync.of(
        KeyEvent.KEY_RELEASED,
        1,
        () -> {
          robot.keyPress(key);
          robot.keyRelease(key);
        });
  }

  /** Replaces what a text control has. */
  void fill(Component text, String by) {
    click(text);
    robot.keyPress(KeyEvent.VK_CONTROL);
    press(KeyEvent.VK_A);
    robot.keyRelease(KeyEvent.VK_CONTROL);
    press(KeyEvent.VK_DELETE);
    type(by);
  }

  void screenshot(String name, int scale) throws IOException {
    BufferedImage image =
        get(
            () -> {
              Container content = window.getContentPane();
              BufferedImage made =
                  new BufferedImage(
                      content.getWidth() * scale,
                      content.getHeight() * scale,
                      BufferedImage.TYPE_INT_RGB);
              Graphics2D g = made.createGraphics();
              g.scale(scale, scale);
              content.paint(g);
              g.dispose();
              return made;
            });
    ImageIO.write(image, "png", Path.of("target", name + ".png").toFile());
  }

  @Override
  public void close() {
    edt(
        () -> {
          form.dispose();
          help.dispose();
          problems.dispose();
          window.dispose();
          session.dispose();
          pictures.close();
          tasks.close();
        });
  }
}
