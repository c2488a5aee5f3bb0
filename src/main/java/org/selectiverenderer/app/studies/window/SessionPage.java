package org.selectiverenderer.app.studies.window;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SpinnerNumberModel;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.studies.ParticipantCheck;
import org.selectiverenderer.app.studies.SessionRequest;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.study.session.StudyPlan;
import org.selectiverenderer.swing.PlainText;

/** Who comes next, the form that starts or resumes a session, and the session that runs. */
final class SessionPage extends JPanel {
  private static final long serialVersionUID = 1;
  private static final int MOST_SESSIONS = 99;

  private final transient StudyDesk desk;
  private final transient LiveSession live;
  private final JLabel next = PlainText.only(new JLabel());
  private final JLabel verdict = PlainText.only(new JLabel());
  private final JTextField id = new JTextField(12);
  private final JSpinner session = new JSpinner(new SpinnerNumberModel(1, 1, MOST_SESSIONS, 1));
  private final JCheckBox view = StudyTexts.checkBox("session.view");
  private final JCheckBox withoutTracker = StudyTexts.checkBox("session.withouttracker");
  private final JCheckBox showCondition = StudyTexts.checkBox("session.showcondition");
  private final JCheckBox unattended = StudyTexts.checkBox("session.unattended");
  private final JComboBox<String> language = new JComboBox<>();
  private final JLabel inLanguage = StudyTexts.label("session.language");
  private final ActionLine start = new ActionLine("session.start", this::start);
  private transient List<String> offered = List.of();
  private @Nullable String suggested;

  SessionPage(StudyDesk desk) {
    super(new MigLayout("insets 12, fill, wrap 1", "[grow,fill]", "[][][grow,fill]"));
    this.desk = desk;
    live = new LiveSession(desk, this::judge);
    id.setName("session.id");
    session.setName("session.number");
    language.setName("session.language");
    inLanguage.setLabelFor(language);
    language.addActionListener(event -> judge());
    next.setName("session.next");
    verdict.setName("session.verdict");
    add(next);
    add(form());
    add(live.view());
    id.getDocument().addDocumentListener(new Changes());
    session.addChangeListener(event -> judge());
    for (JCheckBox box : new JCheckBox[] {view, withoutTracker, showCondition, unattended}) {
      box.addActionListener(event -> judge());
    }
    desk.listen(this::show);
  }

  private JComponent form() {
    JPanel form = new JPanel(new MigLayout("insets 0, fillx", "[][][][][][][grow]", ""));
    JLabel who = StudyTexts.label("session.participant");
    who.setLabelFor(id);
    JLabel number = StudyTexts.label("session.session");
    number.setLabelFor(((JSpinner.DefaultEditor) session.getEditor()).getTextField());
    form.add(who);
    form.add(id);
    form.add(number, "gapleft 12");
    form.add(session);
    form.add(inLanguage, "gapleft 12, hidemode 3");
    form.add(language, "hidemode 3");
    form.add(verdict, "growx, wmin 0, wrap");
    JPanel options = new JPanel(new MigLayout("insets 0, fillx, wrap 2", "[][grow]"));
    options.add(view);
    options.add(withoutTracker);
    options.add(unattended);
    options.add(showCondition);
    form.add(options, "spanx, growx, wrap");
    form.add(start, "spanx, growx");
    return form;
  }

  LiveSession live() {
    return live;
  }

  private void show(Optional<StudyOverview> study) {
    study.ifPresent(
        known -> {
          showCondition.setVisible(known.blind());
          next.setText(sentence(known));
          languages(known.study().languages());
          // What the experimenter has typed stays; a suggestion gives way to the next one.
          if (suggested == null || id.getText().equals(suggested) || id.getText().isEmpty()) {
            suggested = known.ids().next();
            id.setText(suggested);
            session.setValue(1);
          }
        });
    if (study.isEmpty()) {
      suggested = null;
      id.setText("");
    }
    judge();
  }

  private void languages(List<String> codes) {
    if (!codes.equals(offered)) {
      offered = codes;
      language.setModel(new DefaultComboBoxModel<>(codes.toArray(String[]::new)));
    }
    inLanguage.setVisible(codes.size() > 1);
    language.setVisible(codes.size() > 1);
  }

  /** Returns the language to begin in; a known participant keeps the one of earlier sessions. */
  private Optional<String> chosen(ParticipantCheck check) {
    boolean begins =
        check.answer() == ParticipantCheck.Answer.NEW
            || check.answer() == ParticipantCheck.Answer.ALIKE;
    return begins && language.getSelectedIndex() > 0
        ? Optional.of(offered.get(language.getSelectedIndex()))
        : Optional.empty();
  }

  private static String sentence(StudyOverview known) {
    Optional<StudyPlan.Place> place = known.next();
    if (place.isEmpty()) {
      return StudyTexts.of("session.full", Integer.toString(known.study().participants()));
    }
    String number = Integer.toString(place.get().number());
    String planned = Integer.toString(known.study().participants());
    return known.blind()
        ? StudyTexts.of("session.next.blind", number, planned)
        : StudyTexts.of("session.next", number, planned, place.get().group().name());
  }

  private SessionRequest wanted(ParticipantCheck check) {
    return new SessionRequest(
        id.getText().strip(),
        (Integer) session.getValue(),
        check.answer() == ParticipantCheck.Answer.ALIKE,
        check.answer() == ParticipantCheck.Answer.BEGUN,
        chosen(check),
        new SessionRequest.Options(
            view.isSelected(),
            withoutTracker.isSelected(),
            showCondition.isVisible() && showCondition.isSelected(),
            unattended.isSelected()));
  }

  /** Puts the keyboard where a session begins. */
  void focus() {
    id.requestFocusInWindow();
  }

  private ParticipantCheck check(StudyOverview known) {
    return ParticipantCheck.of(known, id.getText().strip(), (Integer) session.getValue());
  }

  /** Tells what would become of the id, and the command line. */
  private void judge() {
    Optional<StudyOverview> study = desk.study();
    if (study.isEmpty()) {
      verdict.setText("");
      start.command(Optional.empty());
      return;
    }
    ParticipantCheck check = check(study.get());
    language.setEnabled(
        check.answer() != ParticipantCheck.Answer.KNOWN
            && check.answer() != ParticipantCheck.Answer.BEGUN);
    verdict.setText(
        StudyTexts.of(
            "check." + check.answer().name().toLowerCase(Locale.ROOT),
            check.other(),
            Integer.toString((Integer) session.getValue() + 1)));
    start
        .button()
        .setText(
            Mnemonics.without(
                StudyTexts.of(
                    check.answer() == ParticipantCheck.Answer.BEGUN
                        ? "session.resume"
                        : "session.start")));
    start.command(
        check.possible() && !live.running()
            ? desk.commands().map(commands -> commands.run(wanted(check)))
            : Optional.empty());
  }

  /** Fills the form for a session that is to be resumed. */
  void resume(String participant, int number) {
    id.setText(participant);
    session.setValue(number);
    start.button().requestFocusInWindow();
  }

  private void start() {
    Optional<StudyOverview> study = desk.study();
    if (study.isEmpty()) {
      return;
    }
    ParticipantCheck check = check(study.get());
    if (live.running()
        || !check.possible()
        || check.answer() == ParticipantCheck.Answer.ALIKE
            && !confirmed("check.alike.ask", id.getText().strip(), check.other())
        || study.get().diskLow()
            && !confirmed("disk.low.ask", Long.toString(study.get().free() >> 20))) {
      return;
    }
    SessionRequest wanted = wanted(check);
    desk.commands()
        .ifPresent(
            commands -> live.start(commands.run(wanted), wanted.participant(), wanted.session()));
  }

  private boolean confirmed(String key, Object... arguments) {
    Object[] answers = {StudyTexts.of("yes"), StudyTexts.of("no")};
    return JOptionPane.showOptionDialog(
            this,
            StudyTexts.of(key, arguments),
            StudyTexts.of("title"),
            JOptionPane.DEFAULT_OPTION,
            JOptionPane.QUESTION_MESSAGE,
            null,
            answers,
            answers[1])
        == 0;
  }

  private final class Changes implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
      judge();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
      judge();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
      judge();
    }
  }
}
