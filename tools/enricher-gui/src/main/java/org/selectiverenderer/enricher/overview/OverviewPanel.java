package org.selectiverenderer.enricher.overview;

import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.component.InputDialog;
import org.selectiverenderer.enricher.component.TextChangeListener;
import org.selectiverenderer.enricher.component.WrapLayout;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The schema overview: an editable table of all objects by all schemas. Its selected row and the
 * session's selection follow each other. For the event dispatch thread.
 */
@SuppressWarnings("serial") // never written
public final class OverviewPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final EnricherSession session;
  private final OverviewTableModel model;
  private final SchemaTable table;
  private final SchemaFindingsPanel findings;
  private final JTextField name = new JTextField(14);
  private final JComboBox<ObjectRowFilter.Which> which =
      new JComboBox<>(ObjectRowFilter.Which.values());
  private final JLabel status = PlainText.only(new JLabel(" "));
  private final org.selectiverenderer.authoring.DocumentListener changes = change -> changed();
  private final SelectionListener selection = this::selected;
  private boolean following;
  private boolean stale;

  public OverviewPanel(EnricherSession session) {
    super(new MigLayout("insets dialog, fill", "[grow,fill]", "[][][][grow,fill][][][]"));
    this.session = session;
    this.model = new OverviewTableModel(session.enrichment(), this::make);
    this.table = new SchemaTable(model);
    this.findings = new SchemaFindingsPanel(e -> session.select(e, this), this::make);
    OverviewActions actions =
        new OverviewActions(table, model, new MetadataClipboard(session), this::say);
    add(filters(), "wmin 0, wrap");
    add(schemaTools(), "wmin 0, wrap");
    add(cellTools(actions), "wmin 0, wrap");
    add(table.scrolling(), "grow, wmin 0, wrap");
    add(findings, "grow, wmin 0, hidemode 3, wrap");
    add(status, "wmin 0, wrap");
    add(legend(), "wmin 0");
    status.getAccessibleContext().setAccessibleName(Texts.of("overview.result"));
    table
        .getSelectionModel()
        .addListSelectionListener(
            e -> {
              if (!e.getValueIsAdjusting()) {
                selectInSession();
              }
            });
    session.document().addListener(changes);
    session.addSelectionListener(selection);
    addHierarchyListener(
        event -> {
          if (stale && isShowing()) {
            refresh();
            selected(session.selection(), session);
          }
        });
    findings.show(model.marks());
    count();
    selected(session.selection(), session);
  }

  private JPanel filters() {
    JPanel tools = new JPanel(new MigLayout("insets 0", "[][grow][]"));
    JLabel filter = Mnemonics.label("overview.filter");
    filter.setLabelFor(name);
    name.putClientProperty("JTextField.placeholderText", Texts.of("overview.filter.part"));
    name.putClientProperty("JTextField.showClearButton", true);
    name.getAccessibleContext().setAccessibleName(Texts.of("overview.filter.name"));
    name.getDocument().addDocumentListener(new TextChangeListener(this::filter));
    which.getAccessibleContext().setAccessibleName(Texts.of("overview.filter.which"));
    which.addActionListener(e -> filter());
    tools.add(filter);
    tools.add(name, "growx, wmin 60");
    tools.add(which, "wmin 60");
    return tools;
  }

  /** Creates a panel whose components wrap into further lines in a narrow window. */
  private static JPanel lines() {
    JPanel lines = new JPanel();
    WrapLayout.in(lines, 4, 1);
    return lines;
  }

  private JPanel schemaTools() {
    JPanel tools = lines();
    tools.add(new JLabel(Texts.of("overview.schema")));
    tools.add(button("overview.add", this::addSchema));
    tools.add(button("overview.rename", this::rename));
    tools.add(button("overview.remove", this::remove));
    return tools;
  }

  private static JPanel cellTools(OverviewActions actions) {
    JPanel tools = new JPanel(new MigLayout("insets 0, wrap 1, gapy 2", "[grow,fill]"));
    JPanel buttons = lines();
    buttons.add(new JLabel(Texts.of("overview.cells")));
    buttons.add(button(actions.high, Texts.of("overview.high.tip")));
    buttons.add(button(actions.low, Texts.of("overview.low.tip")));
    buttons.add(button(actions.clear, Texts.of("overview.clear.tip")));
    buttons.add(new JLabel(Texts.of("overview.keys")));
    tools.add(buttons, "wmin 0");
    JLabel names = new JLabel(Texts.of("terms.table"));
    names.putClientProperty("FlatLaf.styleClass", "small");
    names.setEnabled(false);
    names.setToolTipText(names.getText());
    tools.add(names, "wmin 0");
    return tools;
  }

  private static JPanel legend() {
    JPanel legend = lines();
    legend.add(new JLabel(Texts.of("overview.legend")));
    for (ConsistencySymbol sign : ConsistencySymbol.values()) {
      JLabel label = new JLabel(sign.words(), sign.icon(), JLabel.LEADING);
      legend.add(label);
    }
    return legend;
  }

  private static JButton button(KeyedAction action, String help) {
    JButton button = new JButton(action);
    button.setToolTipText(help);
    button.getAccessibleContext().setAccessibleDescription(help);
    button.setFocusable(false); // keeps the focus and the selection in the table
    return button;
  }

  private static JButton button(String key, Runnable work) {
    JButton button = Mnemonics.button(key);
    String help = Texts.of(key + ".tip");
    button.setToolTipText(help);
    button.getAccessibleContext().setAccessibleName(Texts.of(key + ".name"));
    button.getAccessibleContext().setAccessibleDescription(help);
    button.addActionListener(e -> work.run());
    return button;
  }

  private void addSchema() {
    InputDialog.ask(
            this,
            Texts.of("overview.add.title"),
            Texts.of("overview.add.question"),
            "",
            this::addColumn)
        .ifPresent(
            schema -> {
              int column = model.schemas().indexOf(schema);
              table.setColumnSelectionInterval(column, column);
              table.scrollRectToVisible(table.getCellRect(0, column, true));
              say(Texts.of("overview.added", schema));
            });
  }

  /** Adds the column of a schema; returns why it cannot be added, empty if it is there. */
  private Optional<String> addColumn(String schema) {
    try {
      table.keepingSelection(() -> model.addSchema(schema));
      return Optional.empty();
    } catch (EditRejectedException e) {
      return Optional.of(Remarks.of(e));
    }
  }

  private void rename() {
    Optional<String> schema = table.currentSchema();
    if (schema.isEmpty()) {
      say(Texts.of("overview.rename.first"));
      return;
    }
    InputDialog.ask(
            this,
            Texts.of("overview.rename.title"),
            Texts.of("overview.rename.question", schema.get()),
            schema.get(),
            to -> Optional.empty())
        .filter(to -> !to.equals(schema.get()))
        .ifPresent(
            to ->
                attempt(
                    () -> {
                      make(() -> session.edits().renameSchema(schema.get(), to));
                      table.keepingSelection(() -> model.renamed(schema.get(), to));
                    }));
  }

  private void remove() {
    Optional<String> schema = table.currentSchema();
    if (schema.isEmpty()) {
      say(Texts.of("overview.remove.first"));
      return;
    }
    attempt(
        () -> {
          make(() -> session.edits().removeSchema(schema.get()));
          table.keepingSelection(() -> model.removed(schema.get()));
        });
  }

  private void filter() {
    ObjectRowFilter wanted =
        new ObjectRowFilter(name.getText(), (ObjectRowFilter.Which) which.getSelectedItem());
    follow(() -> table.keepingSelection(() -> model.filter(wanted)));
    count();
  }

  /**
   * Refreshes the table, or when it is hidden only once it is shown again, as many objects take a
   * while.
   */
  private void changed() {
    if (isShowing()) {
      refresh();
    } else {
      stale = true;
    }
  }

  private void refresh() {
    stale = false;
    follow(() -> table.keepingSelection(model::refresh));
    findings.show(model.marks());
    count();
  }

  private void count() {
    int all = model.objectCount();
    String shown =
        model.getRowCount() == all
            ? Texts.of("counts.objects", all, DecimalFormatter.grouped(all))
            : Texts.of(
                "counts.someobjects",
                DecimalFormatter.grouped(model.getRowCount()),
                all,
                DecimalFormatter.grouped(all));
    int schemas = model.schemas().size();
    status.setText(
        all == 0
            ? Texts.of("overview.noobjects")
            : shown
                + ", "
                + Texts.of("counts.schemas", schemas, DecimalFormatter.grouped(schemas)));
  }

  private void say(String message) {
    status.setText(message);
  }

  private void attempt(Runnable work) {
    try {
      work.run();
    } catch (EditRejectedException e) {
      say(Remarks.of(e));
    }
  }

  private void selected(Optional<DocumentElement> element, Object origin) {
    if (!following && !stale) {
      element.ifPresent(selected -> follow(() -> table.show(selected)));
    }
  }

  /** Creates and performs an edit; tells the author why if either is refused. */
  private void make(Supplier<Edit> edit) {
    session.attempt(() -> session.document().perform(edit.get()));
  }

  private void selectInSession() {
    int row = table.getSelectionModel().getLeadSelectionIndex();
    if (!following && row >= 0 && row < model.getRowCount() && table.isRowSelected(row)) {
      DocumentElement element = model.node(row).element();
      follow(() -> session.select(element, this));
    }
  }

  /** Runs a change whose selection events must not be passed on between table and session. */
  private void follow(Runnable change) {
    boolean before = following;
    following = true;
    try {
      change.run();
    } finally {
      following = before;
    }
  }

  /** Stops following the session. */
  public void dispose() {
    session.document().removeListener(changes);
    session.removeSelectionListener(selection);
  }
}
