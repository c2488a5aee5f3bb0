package org.selectiverenderer.enricher.form;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.authoring.placement.PoseField;
import org.selectiverenderer.enricher.placement.PlacementEditor;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The rows of position, rotation and scale of a node that is no Transform, or one that a ROUTE
 * drives: they are those of the Transform around it, which the first change makes if there is none.
 */
final class PlacementForm implements Form {
  private static final Map<PoseField, String> VERBS =
      Map.of(PoseField.TRANSLATION, "move", PoseField.ROTATION, "turn", PoseField.SCALE, "scale");

  private final DocumentElement element;
  private final PlacementEditor editor;
  private final Keyboard keyboard;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 8 0 0 0, gapy 3, hidemode 3, wrap 2", "[][grow,fill]"));
  private final JTextArea about = LabelFactory.sentences("");
  private final List<FieldBinding> rows = new ArrayList<>();

  /**
   * The row that has the keyboard, for the form that takes the place of this one: a node that gets
   * a Transform is parsed again.
   */
  static final class Keyboard {
    private String row = "";
  }

  PlacementForm(EnricherSession session, DocumentElement element, Keyboard keyboard) {
    this.element = element;
    this.editor = new PlacementEditor(session);
    this.keyboard = keyboard;
    JLabel title = new JLabel(Texts.of("placement.form"));
    title.putClientProperty("FlatLaf.styleClass", "h4");
    panel.add(new JSeparator(), "span 2, growx");
    panel.add(title, "span 2");
    panel.add(about, "span 2, growx, wmin 0");
    String wanted = keyboard.row;
    keyboard.row = "";
    for (PoseField field : PoseField.values()) {
      JTextField text = row(field, session.document().locked().isEmpty());
      if (text.getName().equals(wanted)) {
        EventQueue.invokeLater(text::requestFocusInWindow);
      }
    }
    follow();
  }

  /** Returns whether an element's place is that of a Transform around it. */
  static boolean shows(EnricherSession session, DocumentElement element) {
    return new PlacementEditor(session)
        .placement(element)
        .filter(placed -> placed.transform().filter(element::equals).isEmpty())
        .isPresent();
  }

  private JTextField row(PoseField field, boolean free) {
    String key = field.name().toLowerCase(Locale.ROOT);
    JTextField text = new JTextField();
    text.setName("placement " + key);
    text.setEditable(free);
    text.putClientProperty("JTextField.placeholderText", field.usual());
    text.setToolTipText(Texts.of("placement." + key + ".tip"));
    // Before the binding's own listener, which may write and so replace this form.
    text.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            keyboard.row = text.getName();
            panel.scrollRectToVisible(text.getBounds());
          }

          @Override
          public void focusLost(FocusEvent event) {
            Component next = event.getOppositeComponent();
            String name = next == null ? null : next.getName();
            keyboard.row = name == null ? "" : name;
          }
        });
    JLabel complaint = LabelFactory.complaint();
    rows.add(
        FieldBinding.of(
            text,
            complaint,
            new FieldBinding.Source(() -> read(field), value -> write(field, value))));
    String label = Texts.of("placement." + key + ".name");
    text.getAccessibleContext().setAccessibleName(label);
    panel.add(LabelFactory.of(label, text));
    panel.add(text, "wmin 0");
    panel.add(complaint, "skip 1, wmin 0");
    return text;
  }

  private String read(PoseField field) {
    return editor.placement(element).map(field::written).orElse("");
  }

  private Optional<String> write(PoseField field, String text) {
    Optional<Placement> now = editor.placement(element);
    if (now.isEmpty()) {
      return Optional.of(Texts.of("placement.form.gone"));
    }
    try {
      String value = field.value(text);
      editor.set(now.get(), field, value, VERBS.getOrDefault(field, "move"));
      return Optional.empty();
    } catch (EditRejectedException e) {
      return Optional.of(Remarks.of(e));
    }
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public boolean fits() {
    return element.attached()
        && editor
            .placement(element)
            .filter(placed -> placed.transform().filter(element::equals).isEmpty())
            .isPresent();
  }

  @Override
  public void follow() {
    boolean made = editor.placement(element).flatMap(Placement::transform).isPresent();
    String sentence = Texts.of(made ? "placement.form.around" : "placement.form.new");
    about.setText(sentence);
    about.getAccessibleContext().setAccessibleName(sentence);
    rows.forEach(FieldBinding::follow);
  }

  @Override
  public void commit() {
    List.copyOf(rows).forEach(FieldBinding::commit);
  }

  @Override
  public void dispose() {
    rows.forEach(FieldBinding::close);
  }
}
