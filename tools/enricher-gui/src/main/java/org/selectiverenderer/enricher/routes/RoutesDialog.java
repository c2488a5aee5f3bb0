package org.selectiverenderer.enricher.routes;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.routes.RouteEdits;
import org.selectiverenderer.authoring.routes.SceneRoute;
import org.selectiverenderer.authoring.routes.SceneRoute.Fault;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;

/**
 * The dialog of the scene's ROUTEs: they are listed with what is wrong, added and deleted, each as
 * one undo step.
 */
@SuppressWarnings("serial") // never written
public final class RoutesDialog extends JDialog {
  private static final long serialVersionUID = 1L;

  private final EnricherSession session;
  private final Runnable toSource;
  private final RoutesTableModel model = new RoutesTableModel();
  private final JTable table = new JTable(model);
  private final JLabel state = PlainText.only(new JLabel(" "));
  private final JButton delete = Mnemonics.button("routes.delete");
  private final JButton source = Mnemonics.button("routes.source");
  private final RouteBuilder builder;
  private final DocumentListener changes = change -> follow();
  private List<SceneRoute> routes = List.of();

  /**
   * @param toSource shows the selected element in the source, after the dialog is closed
   */
  public RoutesDialog(Window owner, EnricherSession session, Runnable toSource) {
    super(owner, Texts.of("routes.title"), ModalityType.DOCUMENT_MODAL);
    this.session = session;
    this.toSource = toSource;
    this.builder =
        new RouteBuilder(session, edit -> session.attempt(() -> session.document().perform(edit)));
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(new MigLayout("insets dialog, fill", "[grow,fill]", "[grow,fill][][][]"));
    content.add(table(), "grow, wrap");
    content.add(state, "wmin 0, wrap");
    builder.setBorder(BorderFactory.createTitledBorder(Texts.of("routes.new")));
    content.add(builder, "wrap");
    content.add(buttons());
    state.getAccessibleContext().setAccessibleName(Texts.of("routes.state"));
    setContentPane(content);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    session.document().addListener(changes);
    follow();
    WindowPacker.pack(this);
    setLocationRelativeTo(owner);
  }

  private JScrollPane table() {
    PlainText.cells(table);
    table.getAccessibleContext().setAccessibleName(Texts.of("routes.table"));
    table.setFillsViewportHeight(true);
    table.setAutoCreateRowSorter(true);
    table.getTableHeader().setReorderingAllowed(false);
    table.getSelectionModel().setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.getSelectionModel().addListSelectionListener(e -> refresh());
    int[] widths = {240, 240, 100, 320};
    for (int i = 0; i < widths.length; i++) {
      table.getColumnModel().getColumn(i).setPreferredWidth(UIScale.scale(widths[i]));
    }
    table.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke("DELETE"), "deleteRoute");
    table
        .getActionMap()
        .put(
            "deleteRoute",
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent e) {
                deleteChosen();
              }
            });
    JScrollPane pane = new JScrollPane(table);
    pane.setPreferredSize(new Dimension(UIScale.scale(900), UIScale.scale(300)));
    return pane;
  }

  private JPanel buttons() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "[][]push[]"));
    delete.addActionListener(e -> deleteChosen());
    source.addActionListener(e -> showSource());
    JButton close = new JButton(Texts.of("images.close"));
    close.addActionListener(e -> dispose());
    panel.add(delete);
    panel.add(source);
    panel.add(close, "tag ok");
    return panel;
  }

  private void follow() {
    routes = SceneRoute.in(session.document(), session.catalogue());
    model.routes(routes);
    builder.fill();
    refresh();
  }

  private void refresh() {
    boolean some = chosen().isPresent();
    delete.setEnabled(some && session.document().locked().isEmpty());
    source.setEnabled(some);
    long faulty = routes.stream().filter(route -> route.fault() != Fault.NONE).count();
    state.setText(
        Texts.of(
            "routes.total", routes.size(), String.valueOf(routes.size()), String.valueOf(faulty)));
  }

  private Optional<SceneRoute> chosen() {
    int row = table.getSelectedRow();
    return row < 0
        ? Optional.empty()
        : Optional.of(model.row(table.convertRowIndexToModel(row)))
            .filter(route -> route.element().attached());
  }

  private void deleteChosen() {
    chosen()
        .ifPresent(
            route ->
                session.attempt(
                    () ->
                        session
                            .document()
                            .perform(new RouteEdits(session.document()).delete(route))));
  }

  private void showSource() {
    chosen()
        .ifPresent(
            route -> {
              dispose();
              session.select(route.element(), this);
              toSource.run();
            });
  }

  @Override
  public void dispose() {
    session.document().removeListener(changes);
    super.dispose();
  }
}
