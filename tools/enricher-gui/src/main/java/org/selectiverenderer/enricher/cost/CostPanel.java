package org.selectiverenderer.enricher.cost;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.DefaultCellEditor;
import javax.swing.JButton;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingConstants;
import javax.swing.event.CellEditorListener;
import javax.swing.event.ChangeEvent;
import javax.swing.table.DefaultTableCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.polygon.PolygonContributions;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.validation.CostKind;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Shows the cost of the scene: polygons of its parts in each state against limits, bytes of
 * textures and draw calls, and the share of each object in the selected state. For the event
 * dispatch thread.
 */
public final class CostPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private static final double HALF = 0.55;

  /** Pixels that a scroll bar and its frame may take. */
  private static final int SCROLLING = 20;

  private final transient EnricherSession session;
  private final transient BudgetFileLocator place;
  private final transient Runnable settingsChanged;
  private final transient CostUpdater feed;
  private final transient SelectionListener selecting = this::selected;
  private final StatesTableModel states = new StatesTableModel(this::limit);
  private final ObjectsTableModel objects = new ObjectsTableModel();
  private final CostTable statesTable = new CostTable(states, Texts.of("cost.statesname"));
  private final CostTable objectsTable = new CostTable(objects, Texts.of("cost.objectsname"));
  private final JSplitPane split;
  private final JLabel fixed = new JLabel(" ");
  private final JLabel file = PlainText.only(new JLabel(" "));
  private transient List<CostRow> before = List.of();
  private transient Optional<CostRow> chosen = Optional.empty();
  private boolean following;

  /** A count that arrived while the author edits a limit; shown when editing ends. */
  private transient Optional<List<CostRow>> waiting = Optional.empty();

  /**
   * @param settingsChanged runs when the limits or the settings file change
   */
  public CostPanel(EnricherSession session, BudgetFileLocator place, Runnable settingsChanged) {
    super(new MigLayout("insets 4 8 4 8, fill", "[grow,fill]", "[grow,fill][]"));
    this.session = session;
    this.place = place;
    this.settingsChanged = settingsChanged;
    setName("cost");
    getAccessibleContext().setAccessibleName(Texts.of("cost.name"));
    dressStates();
    dressObjects();
    split =
        new JSplitPane(
            JSplitPane.HORIZONTAL_SPLIT,
            true,
            new JScrollPane(statesTable),
            new JScrollPane(objectsTable));
    split.setResizeWeight(HALF);
    split.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            arrange();
          }
        });
    split.setBorder(null);
    split.getAccessibleContext().setAccessibleName(Texts.of("cost.border"));
    JButton choose = new JButton(Texts.of("cost.choose"));
    choose.setName("cost.choose");
    choose.setToolTipText(Texts.of("cost.choosetip", BudgetFileLocator.NAME));
    choose.addActionListener(event -> choose());
    JPanel foot = new JPanel(new MigLayout("insets 0", "[][grow,fill][]"));
    fixed.getAccessibleContext().setAccessibleName(Texts.of("cost.fixedname"));
    foot.add(choose);
    foot.add(file, "wmin 0");
    foot.add(fixed, "wmin 0, gapright 8");
    add(split, "wmin 0, hmin 0, wrap");
    add(foot, "wmin 0");
    session.addSelectionListener(selecting);
    feed = new CostUpdater(session, place, this::found);
    addHierarchyListener(event -> feed.seen(isShowing()));
    tellFile(Optional.empty());
    feed.now();
  }

  /** Puts the tables one above the other where there is no room for both side by side. */
  private void arrange() {
    int borders = split.getDividerSize() + 2 * SCROLLING;
    boolean wide =
        split.getWidth()
            >= statesTable.getMinimumSize().width + objectsTable.getMinimumSize().width + borders;
    int wanted = wide ? JSplitPane.HORIZONTAL_SPLIT : JSplitPane.VERTICAL_SPLIT;
    if (split.getOrientation() != wanted) {
      split.setOrientation(wanted);
      split.setDividerLocation(HALF);
    }
  }

  private void dressStates() {
    statesTable
        .column(StatesTableModel.SCOPE, 9, 8)
        .column(StatesTableModel.STATE, 20, 12)
        .numbers(StatesTableModel.POLYGONS, 9, 8)
        .numbers(StatesTableModel.PERCENT, 7, 7)
        .numbers(StatesTableModel.TEXTURES, 8, 7)
        .numbers(StatesTableModel.DRAWS, 6, 5)
        .column(StatesTableModel.LIMIT, 9, 7)
        .column(StatesTableModel.BAR, 17, 11);
    LimitCell limits = new LimitCell();
    limits.setHorizontalAlignment(SwingConstants.TRAILING);
    statesTable.getColumnModel().getColumn(StatesTableModel.LIMIT).setCellRenderer(limits);
    LimitCellEditor editor = new LimitCellEditor();
    editor.addCellEditorListener(new Written());
    statesTable.getColumnModel().getColumn(StatesTableModel.LIMIT).setCellEditor(editor);
    statesTable
        .getColumnModel()
        .getColumn(StatesTableModel.BAR)
        .setCellRenderer(new BudgetBarRenderer());
    statesTable
        .getColumnModel()
        .getColumn(StatesTableModel.TEXTURES)
        .setCellRenderer(new CostCell(CostKind.TEXTURE_BYTES));
    statesTable
        .getColumnModel()
        .getColumn(StatesTableModel.DRAWS)
        .setCellRenderer(new CostCell(CostKind.DRAW_CALLS));
    statesTable.putClientProperty("terminateEditOnFocusLost", true);
    statesTable
        .getSelectionModel()
        .addListSelectionListener(
            event -> {
              if (!event.getValueIsAdjusting()) {
                showObjects();
              }
            });
  }

  /** Renders a cost with a tooltip that says what is counted, and its limit. */
  private final class CostCell extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;
    private final CostKind kind;

    CostCell(CostKind kind) {
      this.kind = kind;
      setHorizontalAlignment(SwingConstants.TRAILING);
    }

    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      setToolTipText(CostFormatter.costTip(states.row(row), kind));
      return this;
    }
  }

  /** Renders a limit with a tooltip that says whether one can be set. */
  private final class LimitCell extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      boolean can = states.row(row).limitable();
      setToolTipText(Texts.of(can ? "cost.limittip" : "cost.nolimit"));
      if (can && "".equals(value)) {
        setText("\u2026"); // a limit can be set here
      }
      return this;
    }
  }

  private void dressObjects() {
    objectsTable
        .column(ObjectsTableModel.OBJECT, 18, 11)
        .numbers(ObjectsTableModel.POLYGONS, 8, 8)
        .numbers(ObjectsTableModel.PERCENT, 7, 6)
        .column(ObjectsTableModel.SHOWN, 8, 8)
        .column(ObjectsTableModel.VERSIONS, 14, 9);
    objectsTable
        .getSelectionModel()
        .addListSelectionListener(
            event -> {
              int row = objectsTable.getSelectedRow();
              if (!event.getValueIsAdjusting() && !following && row >= 0) {
                select(objects.row(row).name());
              }
            });
  }

  private void select(String object) {
    Optional<EnrichedSwitch> node =
        session.enrichment().switches().stream()
            .filter(each -> each.name().equals(object))
            .findFirst();
    node.ifPresentOrElse(
        found -> session.select(found.element(), this),
        () -> session.message(Texts.of("cost.elsewhere", object)));
  }

  private void selected(Optional<DocumentElement> element, Object origin) {
    if (origin != this) {
      follow();
    }
  }

  /** Selects the row of the object that is selected in other views. */
  private void follow() {
    int row =
        session
            .selection()
            .flatMap(element -> session.enrichment().switchNode(element))
            .map(node -> objects.row(node.name()))
            .orElse(-1);
    following = true;
    try {
      if (row < 0) {
        objectsTable.clearSelection();
      } else {
        objectsTable.setRowSelectionInterval(row, row);
        objectsTable.scrollRectToVisible(objectsTable.getCellRect(row, 0, true));
      }
    } finally {
      following = false;
    }
  }

  private void found(CostUpdater.Found found) {
    found.rows().ifPresent(this::show);
    tellFile(found.fault());
  }

  /** Shows a waiting count when the author has finished editing a limit. */
  private final class Written implements CellEditorListener {
    @Override
    public void editingStopped(ChangeEvent event) {
      EventQueue.invokeLater(this::showWaiting); // after the table has set the value
    }

    @Override
    public void editingCanceled(ChangeEvent event) {
      EventQueue.invokeLater(this::showWaiting);
    }

    private void showWaiting() {
      Optional<List<CostRow>> rows = waiting;
      waiting = Optional.empty();
      rows.ifPresent(CostPanel.this::show);
    }
  }

  /** Whether a count waits until the author has finished editing a limit. */
  boolean waits() {
    return waiting.isPresent();
  }

  private void show(List<CostRow> rows) {
    if (statesTable.isEditing()) {
      waiting = Optional.of(rows);
      return;
    }
    states.rows(rows);
    warn(rows);
    before = rows;
    int row = 0;
    for (int i = 0; i < rows.size(); i++) {
      CostRow each = rows.get(i);
      boolean usual = chosen.isEmpty() && each.kind() == CostRow.Kind.LOADED;
      if (usual || chosen.filter(each::same).isPresent()) {
        row = i;
        break;
      }
    }
    if (!rows.isEmpty()) {
      statesTable.setRowSelectionInterval(row, row);
    }
    showObjects();
  }

  /** Reports the first limit that was kept before and is exceeded now. */
  private void warn(List<CostRow> rows) {
    for (CostRow row : rows) {
      if (row.broken() && row.held(before)) {
        session.message(CostFormatter.warning(row, row.status().orElseThrow()));
        return;
      }
    }
  }

  private void showObjects() {
    int row = statesTable.getSelectedRow();
    if (row >= 0) {
      chosen = Optional.of(states.row(row));
    }
    Optional<PolygonContributions> shares = chosen.flatMap(CostRow::shares);
    following = true;
    objects.show(shares);
    following = false;
    fixed.setText(
        shares.map(CostPanel::rest).orElse(chosen.isPresent() ? Texts.of("cost.noshares") : " "));
    fixed.setToolTipText(fixed.getText().isBlank() ? null : fixed.getText());
    follow();
  }

  /** Describes the polygons that the list of objects leaves out. */
  private static String rest(PolygonContributions shares) {
    return shares.objects().isEmpty()
        ? Texts.of("cost.plain")
        : Texts.of("cost.fixed", DecimalFormatter.grouped(shares.fixed()));
  }

  private void tellFile(Optional<String> fault) {
    String text =
        fault.orElseGet(() -> Texts.of("cost.file", String.valueOf(place.file().getFileName())));
    file.setText((fault.isPresent() ? "\u26a0 " : "") + text);
    file.setToolTipText(PlainText.of(fault.orElseGet(() -> place.file().toString())));
  }

  /** Writes a limit to the settings file, or removes it, and counts again. */
  private void limit(CostRow row, Optional<Long> most) {
    session
        .tasks()
        .runToEnd(
            Texts.of("cost.writing"),
            () -> {
              if (most.isPresent()) {
                place.budgets().put(row.budget(place.sceneName(), most.get()));
              } else {
                place.budgets().remove(row.budget(place.sceneName(), 0));
              }
              return place.file();
            },
            written -> settingsAreOther(),
            failed -> session.message(String.valueOf(failed.getMessage())));
  }

  private void settingsAreOther() {
    feed.now();
    settingsChanged.run();
  }

  private void choose() {
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setCurrentDirectory(place.file().getParent().toFile());
    chooser.setDialogTitle(Texts.of("cost.chooser"));
    chooser.setFileHidingEnabled(false);
    chooser.setSelectedFile(new File(place.file().toString()));
    if (chooser.showDialog(this, Texts.of("cost.use")) == JFileChooser.APPROVE_OPTION) {
      use(chooser.chosen());
    }
  }

  /** Uses another settings file. */
  void use(Path other) {
    place.choose(other);
    tellFile(Optional.empty());
    settingsAreOther();
  }

  /** Counts again, as files that the scene names may have changed. */
  public void lookAtFilesAgain() {
    feed.forget();
  }

  /** Ends its counting. */
  public void dispose() {
    session.removeSelectionListener(selecting);
    feed.dispose();
  }

  /** The cell editor of a limit. It stays open and marked until the text is a number or empty. */
  private static final class LimitCellEditor extends DefaultCellEditor {
    private static final long serialVersionUID = 1L;

    LimitCellEditor() {
      super(new JTextField());
      JTextField field = (JTextField) getComponent();
      field.setHorizontalAlignment(JTextField.TRAILING);
      field.getAccessibleContext().setAccessibleName(Texts.of("cost.limit"));
      field.setToolTipText(Texts.of("cost.limittip"));
    }

    @Override
    public boolean stopCellEditing() {
      JTextField field = (JTextField) getComponent();
      String text = field.getText();
      boolean fits = text.isBlank() || StatesTableModel.number(text).isPresent();
      field.putClientProperty("JComponent.outline", fits ? null : "error");
      return fits && super.stopCellEditing();
    }

    @Override
    public void cancelCellEditing() {
      ((JTextField) getComponent()).putClientProperty("JComponent.outline", null);
      super.cancelCellEditing();
    }
  }
}
