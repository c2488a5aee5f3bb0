package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import javax.swing.text.JTextComponent;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.NumberKeys;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.QuestionnaireProgress;
import org.selectiverenderer.study.questionnaire.RankingField;
import org.selectiverenderer.study.questionnaire.SliderField;
import org.selectiverenderer.swing.PlainText;

/**
 * The window of a questionnaire, which shows a page at a time with a way back. It closes when all
 * questions are answered and the participant goes on from the last page, or when the session ends;
 * closing it asks the experimenter whether to end the session.
 */
public final class QuestionnaireWindow {
  private static final int WIDTH = 980;
  private static final int LEAST_HEIGHT = 460;
  private static final int MOST_HEIGHT = 1000;

  /** Milliseconds between two calls that keep the audio going. */
  private static final int HEAR = 50;

  /**
   * A questionnaire to be asked of a participant.
   *
   * @param known answers given before, by the questions' ids
   * @param from id of the page to begin with; the first page if there is none with this id
   * @param mayRefuse whether the participant may refuse consent here
   */
  public record Asking(
      Questionnaire questionnaire,
      ParticipantMessages wording,
      String participant,
      Map<String, Answer> known,
      Optional<String> from,
      boolean mayRefuse) {
    public Asking {
      known = Map.copyOf(known);
    }
  }

  private final Asking asking;
  private final Consumer<Boolean> done;
  private final QuestionnaireProgress course;
  private final MonitorBounds desk;
  private final JFrame frame;
  private final JPanel middle = new JPanel(new BorderLayout());
  private final PageFooter foot;
  private final KeyEventDispatcher keys = this::key;
  private final Optional<Narration> narration;
  private final Timer hear;
  private PagePanel panel;

  private QuestionnaireWindow(
      Asking asking,
      QuestionnaireProgress.Listener listener,
      SessionEndWatcher sessionEnd,
      MonitorBounds desk,
      Optional<Narration> narration,
      Consumer<Boolean> done) {
    this.narration = narration;
    hear = new Timer(HEAR, event -> narrate());
    this.asking = asking;
    this.desk = desk;
    frame = new JFrame(desk.configuration());
    this.done = done;
    course =
        new QuestionnaireProgress(
            asking.questionnaire(), asking.wording(), asking.known(), asking.from(), listener);
    foot =
        new PageFooter(
            asking.wording(),
            hintLines(),
            this::back,
            this::goOn,
            () -> narration.ifPresent(Narration::again));
    panel = make(course.page());
    JPanel south = new JPanel(new BorderLayout());
    south.add(foot.component(), BorderLayout.CENTER);
    if (asking.mayRefuse()) {
      south.add(refusing(), BorderLayout.WEST);
    }
    frame.setName("questionnaire");
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.add(middle, BorderLayout.CENTER);
    frame.add(south, BorderLayout.SOUTH);
    size();
    lay();
    hear.start();
    sessionEnd.watch(frame, () -> end(false));
    frame.addWindowFocusListener(
        new WindowAdapter() {
          @Override
          public void windowGainedFocus(WindowEvent event) {
            EventQueue.invokeLater(() -> panel.focus());
          }
        });
    KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(keys);
  }

  /** Returns how many lines the explanation of the keys has: more where fields take many keys. */
  private int hintLines() {
    boolean many =
        asking.questionnaire().questions().stream()
            .flatMap(question -> question.kind().fields(asking.wording()).stream())
            .anyMatch(
                field ->
                    !(field instanceof AnswerField.Choice || field instanceof AnswerField.Line));
    return many ? 4 : 2;
  }

  private JPanel refusing() {
    JButton refuse = new JButton(PlainText.of(asking.wording().of("form.cancel")));
    refuse.setName("cancel");
    refuse.setFocusable(false);
    refuse.addActionListener(event -> end(false));
    JPanel line = new JPanel(new FlowLayout(FlowLayout.LEFT, 16, 14));
    line.setBorder(PageFooter.rule());
    line.add(refuse);
    return line;
  }

  /**
   * Asks a questionnaire, and waits until it is answered or the session ends.
   *
   * @param listener receives every page, answer and change of an answer, on Swing's thread
   * @param desk the participant's monitor
   * @param narration plays the audio of the pages; empty for silence
   * @return whether all questions were answered and the participant went on
   */
  public static boolean ask(
      Asking asking,
      QuestionnaireProgress.Listener listener,
      SessionEndWatcher sessionEnd,
      MonitorBounds desk,
      Optional<Narration> narration) {
    AtomicBoolean through = new AtomicBoolean();
    ModalWindowRunner.on(
        finished ->
            new QuestionnaireWindow(
                    asking,
                    listener,
                    sessionEnd,
                    desk,
                    narration,
                    complete -> {
                      through.set(complete);
                      finished.run();
                    })
                .frame);
    return through.get();
  }

  /** Sizes the window for all pages: by the tallest one, as far as the screen allows. */
  private void size() {
    Rectangle most = desk.area();
    int width = Math.min(WIDTH, most.width);
    int tallest =
        asking.questionnaire().pages().stream()
            .mapToInt(
                each ->
                    PageHeader.of(
                                each,
                                asking.wording(),
                                asking.participant(),
                                asking.mayRefuse(),
                                width)
                            .getPreferredSize()
                            .height
                        + make(each).tallest())
            .max()
            .orElse(0);
    int height = tallest + foot.component().getPreferredSize().height + 60;
    frame.setSize(
        new Dimension(
            width, Math.min(most.height, Math.max(LEAST_HEIGHT, Math.min(MOST_HEIGHT, height)))));
    desk.center(frame);
  }

  private PagePanel make(QuestionnairePage which) {
    return new PagePanel(which, course, asking.wording(), WIDTH - 80, this::count);
  }

  private void lay() {
    QuestionnairePage page = course.page();
    middle.removeAll();
    int width = frame.getWidth();
    middle.add(
        PageHeader.of(page, asking.wording(), asking.participant(), asking.mayRefuse(), width),
        page.questions().isEmpty() ? BorderLayout.CENTER : BorderLayout.NORTH);
    if (!page.questions().isEmpty()) {
      middle.add(panel.component(), BorderLayout.CENTER);
    }
    frame.setTitle(page.title().isEmpty() ? asking.wording().of("form.title") : page.title());
    middle.revalidate();
    middle.repaint();
    count();
    panel.begin();
    course.begin();
  }

  private void narrate() {
    narration.ifPresent(
        player ->
            player.show(
                asking.questionnaire().id() + '/' + course.page().id(), course.page().audio()));
  }

  private void count() {
    foot.audible(narration.isPresent() && course.page().audio().isPresent());
    foot.show(
        course.number(),
        course.pages().size(),
        course.open(),
        course.needed(),
        course.refuses(),
        course.page().questions().isEmpty() ? "" : hint(),
        asking.mayRefuse());
  }

  private String hint() {
    ParticipantMessages wording = asking.wording();
    List<String> kinds =
        course.page().questions().stream()
            .map(question -> question.kind().spelling())
            .distinct()
            .toList();
    String keysOf =
        wording.filled(
            "keys",
            kinds.size() == 1 ? wording.of("keys." + kinds.get(0)) : wording.of("keys.mixed"));
    boolean lines =
        course.page().questions().stream()
            .flatMap(question -> question.kind().fields(wording).stream())
            .anyMatch(field -> field instanceof AnswerField.Line line && line.lines() > 1);
    boolean digits =
        course.page().questions().stream()
            .flatMap(question -> question.kind().fields(wording).stream())
            .anyMatch(field -> NumberKeys.of(field).filter(NumberKeys::mayWait).isPresent());
    boolean orders =
        course.page().questions().stream()
            .flatMap(question -> question.kind().fields(wording).stream())
            .anyMatch(RankingField.class::isInstance);
    boolean thumbs =
        course.page().questions().stream()
            .flatMap(question -> question.kind().fields(wording).stream())
            .anyMatch(SliderField.class::isInstance);
    return keysOf
        + (digits ? " " + wording.of("keys.digits") : "")
        + (lines ? " " + wording.of("keys.lines") : "")
        + (course.pages().size() > 1 ? " " + wording.of("keys.back") : "")
        + (thumbs ? " " + wording.of("keys.thumb") : "")
        + (orders ? " " + wording.of("keys.order") : "");
  }

  private boolean key(KeyEvent event) {
    KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
    if (focus.getActiveWindow() != frame) {
      return false;
    }
    boolean writing = focus.getFocusOwner() instanceof JTextComponent;
    if (event.getID() == KeyEvent.KEY_PRESSED && event.getKeyCode() == KeyEvent.VK_ENTER) {
      boolean lines = focus.getFocusOwner() instanceof javax.swing.JTextArea;
      boolean control = (event.getModifiersEx() & InputEvent.CTRL_DOWN_MASK) != 0;
      if (lines && !control) {
        return false; // A new line.
      }
      boolean waited = panel.waits();
      panel.settle();
      if (!waited) { // Else Enter ends a number.
        goOn();
      }
      return true;
    }
    if (event.getID() != KeyEvent.KEY_RELEASED && panel.key(event, writing)) {
      return true;
    }
    if (event.getID() == KeyEvent.KEY_PRESSED && event.getKeyCode() == KeyEvent.VK_PAGE_UP) {
      back();
      return true;
    }
    return false;
  }

  private void back() {
    turn(-1);
  }

  private void goOn() {
    panel.settle();
    if (course.mayGoOn() && !turn(1)) {
      end(true);
    }
  }

  private boolean turn(int by) {
    panel.settle();
    boolean turned = course.turn(by);
    if (turned) {
      panel = make(course.page());
      lay();
    }
    return turned;
  }

  private void end(boolean complete) {
    panel.settle();
    KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(keys);
    foot.close();
    hear.stop();
    narration.ifPresent(Narration::hide);
    done.accept(complete);
  }
}
