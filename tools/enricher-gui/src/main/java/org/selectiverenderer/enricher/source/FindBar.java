package org.selectiverenderer.enricher.source;

import java.awt.Component;
import java.awt.event.ActionEvent;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SortingFocusTraversalPolicy;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.editing.TextSearch;
import org.selectiverenderer.enricher.component.TextChangeListener;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The find and replace bar below the source. It searches while one types; Enter goes to the next
 * hit, Shift+Enter to the previous one, Escape closes the bar.
 */
final class FindBar {
  private static final int PAUSE_MILLISECONDS = 200;

  private final FindReplaceController work;
  private final JTextField words = new JTextField(18);
  private final JTextField replacement = new JTextField(18);
  private final JCheckBox expression = box("source.expression", "findExpression");
  private final JCheckBox matchCase = box("source.matchCase", "findMatchCase");
  private final JCheckBox wholeWords = box("source.wholeWords", "findWholeWords");
  private final JCheckBox inSelection = box("source.inSelection", "findInSelection");
  private final JLabel state = new JLabel();
  private final JPanel replacing = new JPanel(new MigLayout("insets 0", "[][][][]"));
  private final JPanel panel =
      new JPanel(new MigLayout("insets 4 6 4 6, hidemode 3, gapy 2", "[grow]"));
  private final Timer pause = new Timer(PAUSE_MILLISECONDS, event -> search());

  FindBar(FindReplaceController work) {
    this.work = work;
    pause.setRepeats(false);
    words.setName("findWords");
    words.getAccessibleContext().setAccessibleName(Texts.of("source.find"));
    words.putClientProperty("JTextField.placeholderText", Texts.of("source.find"));
    replacement.setName("findReplacement");
    replacement.getAccessibleContext().setAccessibleName(Texts.of("source.replaceBy"));
    replacement.putClientProperty("JTextField.placeholderText", Texts.of("source.replaceBy"));
    state.setName("findState");
    JPanel finding = new JPanel(new MigLayout("insets 0", "[][][][][]"));
    finding.add(words);
    JButton previous = button("source.previous", "findPrevious", () -> step(-1));
    JButton next = button("source.next", "findNext", () -> step(1));
    finding.add(previous);
    finding.add(next);
    finding.add(state);
    JPanel choices = new JPanel(new MigLayout("insets 0", "[][][][]"));
    for (JCheckBox box : List.of(expression, matchCase, wholeWords, inSelection)) {
      choices.add(box);
      box.addActionListener(event -> search());
    }
    replacing.add(replacement);
    JButton one = button("source.replace", "replaceOne", this::replaceOne);
    JButton all = button("source.replaceAll", "replaceAll", this::replaceAll);
    replacing.add(one);
    replacing.add(all);
    tabOrder(
        List.of(
            words,
            replacement,
            one,
            all,
            previous,
            next,
            expression,
            matchCase,
            wholeWords,
            inSelection));
    panel.add(finding, "wrap");
    panel.add(replacing, "wrap");
    panel.add(choices);
    inSelection.addActionListener(event -> work.within(inSelection.isSelected()));
    words.getDocument().addDocumentListener(new TextChangeListener(pause::restart));
    words.addActionListener(event -> step(1));
    replacement.addActionListener(event -> replaceOne());
    on("shift ENTER", () -> step(-1));
    on("ESCAPE", this::close);
    work.onFound(this::show);
    panel.setVisible(false);
  }

  /** Has Tab go from what is searched for to what replaces it, and only then to the buttons. */
  private void tabOrder(List<Component> order) {
    panel.setFocusTraversalPolicyProvider(true);
    panel.setFocusTraversalPolicy(
        new SortingFocusTraversalPolicy(Comparator.comparingInt(order::indexOf)) {
          @Override
          protected boolean accept(Component component) {
            return order.contains(component) && super.accept(component);
          }
        });
  }

  private static JCheckBox box(String text, String name) {
    JCheckBox box = new JCheckBox(Texts.of(text));
    box.setName(name);
    return box;
  }

  private static JButton button(String text, String name, Runnable work) {
    JButton button = new JButton(Texts.of(text));
    button.setName(name);
    button.addActionListener(event -> work.run());
    return button;
  }

  private void on(String key, Runnable run) {
    panel
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(key), key);
    panel
        .getActionMap()
        .put(
            key,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  JPanel component() {
    return panel;
  }

  /**
   * Opens the bar.
   *
   * @param replace whether to show the line for replacing
   * @param selected text to search for; empty for the last search
   */
  void open(boolean replace, String selected) {
    replacing.setVisible(replace);
    panel.setVisible(true);
    boolean lines = selected.indexOf('\n') >= 0;
    if (!selected.isEmpty() && !lines) {
      words.setText(selected);
    }
    inSelection.setSelected(lines);
    work.within(lines);
    words.selectAll();
    words.requestFocusInWindow();
    search();
  }

  void close() {
    pause.stop();
    panel.setVisible(false);
    work.end();
  }

  /** Goes to the next or previous hit; opens the bar if there is no search yet. */
  void step(int by) {
    if (words.getText().isEmpty()) {
      open(false, "");
      return;
    }
    pause.stop();
    work.search(wanted());
    work.step(by);
  }

  private TextSearch.Wanted wanted() {
    return new TextSearch.Wanted(
        words.getText(), expression.isSelected(), matchCase.isSelected(), wholeWords.isSelected());
  }

  private void search() {
    pause.stop();
    if (panel.isVisible()) {
      work.search(wanted());
      work.stepToNearest();
    }
  }

  private void replaceOne() {
    work.search(wanted());
    work.replaceOne(replacement.getText());
  }

  private void replaceAll() {
    work.search(wanted());
    work.replaceAll(replacement.getText());
  }

  private void show(FindReplaceController.Found found) {
    boolean wrong = !found.complaint().isEmpty();
    boolean none = found.count() == 0 && !words.getText().isEmpty();
    words.putClientProperty("JComponent.outline", wrong || none ? "error" : null);
    if (wrong) {
      state.setText(found.complaint());
    } else if (words.getText().isEmpty()) {
      state.setText(" ");
    } else if (found.now() > 0) {
      String key = found.wrapped() ? "source.hitWrapped" : "source.hit";
      state.setText(Texts.of(key, number(found.now()), count(found)));
    } else {
      state.setText(Texts.of("source.hits", found.count(), count(found)));
    }
  }

  private static String count(FindReplaceController.Found found) {
    return (found.count() >= TextSearch.MOST ? ">" : "") + number(found.count());
  }

  private static String number(int hits) {
    return String.format(Locale.ROOT, "%,d", hits);
  }
}
