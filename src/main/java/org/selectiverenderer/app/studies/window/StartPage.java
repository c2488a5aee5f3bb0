package org.selectiverenderer.app.studies.window;

import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.List;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.swing.PlainText;

/** The page without a study: those opened lately, to open another, to make a new one. */
final class StartPage extends JPanel {
  private static final long serialVersionUID = 1;

  private final transient StudyDesk desk;
  private final DefaultListModel<Path> studies = new DefaultListModel<>();
  private final JList<Path> list = PlainText.entries(new JList<>(studies));
  private final JLabel head = new JLabel();
  private final JButton again = StudyTexts.button("start.again");
  private final JButton forget = StudyTexts.button("start.forget");

  /**
   * @param choose asks for a study file
   * @param create makes a new study
   */
  StartPage(StudyDesk desk, Runnable choose, Runnable create) {
    super(new MigLayout("insets 16, fill, wrap 1", "[grow,fill]", "[][grow,fill][]"));
    this.desk = desk;
    head.setName("start.head");
    list.setName("start.recent");
    list.getAccessibleContext().setAccessibleName(StudyTexts.of("start.recent"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.addListSelectionListener(event -> select());
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
              open();
            }
          }
        });
    list.registerKeyboardAction(
        event -> open(), KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), WHEN_FOCUSED);
    JButton other = StudyTexts.button("start.open");
    other.addActionListener(event -> choose.run());
    JButton fresh = StudyTexts.button("start.new");
    fresh.addActionListener(event -> create.run());
    again.addActionListener(event -> open());
    forget.addActionListener(event -> forget());
    add(head);
    add(new JScrollPane(list), "grow, push");
    JPanel buttons = new JPanel(new MigLayout("insets 0, fillx", "[][][grow][][]"));
    buttons.add(again);
    buttons.add(forget);
    buttons.add(other, "skip 1");
    buttons.add(fresh);
    add(buttons);
    select();
  }

  /** Reads the list anew. */
  void reload() {
    desk.recent(this::show);
  }

  private void show(List<Path> known) {
    studies.clear();
    studies.addAll(known);
    head.setText(StudyTexts.of(known.isEmpty() ? "start.none" : "start.recent"));
    if (!known.isEmpty()) {
      list.setSelectedIndex(0);
    }
    select();
  }

  private void select() {
    boolean chosen = list.getSelectedValue() != null;
    again.setEnabled(chosen);
    forget.setEnabled(chosen);
  }

  private void open() {
    Path chosen = list.getSelectedValue();
    if (chosen != null) {
      desk.open(chosen);
    }
  }

  private void forget() {
    Path chosen = list.getSelectedValue();
    if (chosen != null) {
      desk.forget(chosen, this::reload);
    }
  }
}
