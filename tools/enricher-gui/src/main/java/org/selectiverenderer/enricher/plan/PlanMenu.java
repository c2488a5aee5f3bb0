package org.selectiverenderer.enricher.plan;

import java.util.Optional;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.NamePrompt;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.geometry.BoundingBox;

/** The commands for the selected area in the plan, for its context menu and keys. */
final class PlanMenu {
  private final FloorPlanCanvas view;
  private final AreaCommands commands;
  private final NamePrompt question;
  private final PlanObjects objects;
  private final Runnable changed;
  private @Nullable AreaInstance copied;

  /**
   * @param objects the objects of the plan
   * @param changed draws the plan again after objects were hidden or shown
   */
  PlanMenu(
      FloorPlanCanvas view,
      AreaCommands commands,
      NamePrompt question,
      PlanObjects objects,
      Runnable changed) {
    this.objects = objects;
    this.changed = changed;
    this.view = view;
    this.commands = commands;
    this.question = question;
  }

  void rename() {
    view.selected().ifPresent(area -> commands.nodes().rename(area.element(), question));
  }

  void delete() {
    view.selected().ifPresent(area -> commands.nodes().delete(area.element()));
  }

  void copy() {
    copied = view.selected().orElse(copied);
  }

  /**
   * Pastes a copy of the copied area: beside it if it is visible, else in the middle of the visible
   * part.
   */
  void paste() {
    AreaInstance from = copied;
    if (from == null || !from.element().attached()) {
      return;
    }
    BoundingBox seen = view.scale().seen(view.getVisibleRect());
    BoundingBox box = FloorPlanCanvas.bounds(from);
    Vector3d shift = new Vector3d(box.width() * 0.25, 0, box.depth() * 0.25);
    if (seen.apart(new BoundingBox(box.minX(), 0, box.minZ(), box.maxX(), 0, box.maxZ()))) {
      shift.set(
          (seen.minX() + seen.maxX() - box.minX() - box.maxX()) / 2,
          0,
          (seen.minZ() + seen.maxZ() - box.minZ() - box.maxZ()) / 2);
    }
    commands.nodes().copy(from, shift, view);
  }

  /** Hides the selected objects in the plan. */
  void hide() {
    if (view.selected().isEmpty() && objects.any()) {
      objects.hide();
      changed.run();
    }
  }

  /** Shows all objects again. */
  void showAll() {
    objects.showAll();
    changed.run();
  }

  void show(int x, int y) {
    Optional<AreaInstance> selected = view.selected();
    JPopupMenu menu = new JPopupMenu();
    if (selected.isPresent()) {
      menu.add(item("area.rename", "F2", this::rename));
      menu.add(item("area.copy", "ctrl C", this::copy));
    }
    if (copied != null) {
      menu.add(item("area.plan.paste", "ctrl V", this::paste));
    }
    if (selected.isPresent()) {
      menu.add(item("area.delete", "DELETE", this::delete));
      menu.addSeparator();
    }
    if (selected.isEmpty() && objects.any()) {
      menu.add(item("placement.plan.hide", "H", this::hide));
      menu.add(item("placement.onfloor", "", objects.commands()::putOnFloor));
      menu.add(item("placement.group", "", objects.commands()::group));
      menu.add(item("placement.ungroup", "", objects.commands()::ungroup));
      menu.addSeparator();
    }
    if (!objects.hidden().isEmpty()) {
      menu.add(item("placement.plan.showall", "shift H", this::showAll));
      menu.addSeparator();
    }
    menu.add(item("area.add", "", commands::addAroundSelection));
    menu.add(item("area.plan.fit", "HOME", view::fit));
    menu.show(view, x, y);
  }

  private static JMenuItem item(String key, String stroke, Runnable does) {
    MnemonicText title = MnemonicText.of(Texts.of(key));
    JMenuItem item = new JMenuItem(title.words(), title.letter());
    if (!stroke.isEmpty()) {
      item.setAccelerator(KeyStroke.getKeyStroke(stroke));
    }
    item.addActionListener(event -> does.run());
    return item;
  }
}
