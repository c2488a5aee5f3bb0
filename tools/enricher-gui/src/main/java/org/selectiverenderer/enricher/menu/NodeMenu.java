package org.selectiverenderer.enricher.menu;

import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The context menu of the selected node. */
public final class NodeMenu {
  private final EnricherSession session;
  private final List<List<NodeCommand>> groups = new ArrayList<>();

  public NodeMenu(EnricherSession session) {
    this.session = session;
  }

  /** Adds a group of commands below a separator. */
  public void add(List<NodeCommand> commands) {
    groups.add(List.copyOf(commands));
  }

  /** Adds a command to the last group. */
  public void add(NodeCommand command) {
    if (groups.isEmpty()) {
      add(List.of(command));
    } else {
      List<NodeCommand> more = new ArrayList<>(groups.remove(groups.size() - 1));
      more.add(command);
      groups.add(more);
    }
  }

  /** Appends the commands for the selected node to a menu; none while no node is selected. */
  public void fill(JPopupMenu menu) {
    Optional<DocumentElement> selected = session.selection().filter(DocumentElement::attached);
    if (selected.isEmpty()) {
      return;
    }
    for (List<NodeCommand> group : groups) {
      if (menu.getComponentCount() > 0) {
        menu.addSeparator();
      }
      for (NodeCommand command : group) {
        MnemonicText title = MnemonicText.of(command.title());
        JMenuItem item = new JMenuItem(title.words(), title.letter());
        item.setName(command.id());
        item.setEnabled(command.fits().test(selected.get()));
        if (!command.key().isEmpty()) {
          item.setAccelerator(KeyStroke.getKeyStroke(command.key()));
        }
        item.addActionListener(event -> command.work().accept(selected.get()));
        menu.add(item);
      }
    }
  }

  /** Shows the menu of the selected node; reports it if none is selected. */
  public void show(Component over, Point at) {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("nodeMenu");
    fill(menu);
    if (menu.getComponentCount() == 0) {
      session.message(Texts.of("node.none"));
    } else {
      menu.show(over, at.x, at.y);
    }
  }

  /**
   * Opens the menu on a tree by the popup trigger of the mouse, which also selects the row, and by
   * the context menu keys.
   */
  public void attach(JTree tree) {
    tree.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            maybeShow(event);
          }

          @Override
          public void mouseReleased(MouseEvent event) {
            maybeShow(event);
          }

          private void maybeShow(MouseEvent event) {
            int row = tree.getRowForLocation(event.getX(), event.getY());
            if (event.isPopupTrigger() && row >= 0 && tree.isEnabled()) {
              if (!tree.isRowSelected(row)) {
                tree.setSelectionRow(row);
              }
              show(tree, event.getPoint());
            }
          }
        });
    for (String key : List.of("CONTEXT_MENU", "shift F10")) {
      tree.getInputMap().put(KeyStroke.getKeyStroke(key), "nodeMenu");
    }
    tree.getActionMap()
        .put(
            "nodeMenu",
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                Rectangle row = tree.getRowBounds(Math.max(0, tree.getLeadSelectionRow()));
                show(tree, row == null ? new Point() : new Point(row.x, row.y + row.height));
              }
            });
  }
}
