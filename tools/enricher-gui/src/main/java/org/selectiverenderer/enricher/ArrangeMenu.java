package org.selectiverenderer.enricher;

import java.util.function.Consumer;
import javax.swing.JMenu;
import org.selectiverenderer.authoring.placement.Arrangement;
import org.selectiverenderer.enricher.placement.PlacementCommands;
import org.selectiverenderer.enricher.text.Texts;

/** The menu of the commands that arrange the selected nodes. */
final class ArrangeMenu {
  private ArrangeMenu() {}

  static JMenu of(EnricherWindow window) {
    JMenu menu = new JMenu(new MenuAction(Texts.of("placement.arrange"), "", () -> {}));
    menu.add(command(window, "group", "ctrl shift G", PlacementCommands::group));
    menu.add(command(window, "ungroup", "ctrl shift U", PlacementCommands::ungroup));
    menu.add(command(window, "onfloor", "", PlacementCommands::putOnFloor));
    menu.add(command(window, "parent", "", PlacementCommands::selectParent));
    for (int axis = 0; axis < 3; axis++) {
      int of = axis;
      menu.addSeparator();
      for (Arrangement.Side side : Arrangement.Side.values()) {
        menu.add(command(window, "align." + axis + "." + side, "", c -> c.align(of, side)));
      }
      menu.add(command(window, "distribute." + axis, "", c -> c.distribute(of)));
    }
    return menu;
  }

  private static MenuAction command(
      EnricherWindow window, String key, String stroke, Consumer<PlacementCommands> work) {
    return new MenuAction(
        Texts.of("placement." + key),
        stroke,
        () ->
            window
                .bench()
                .ifPresent(
                    bench -> {
                      bench.commit();
                      work.accept(bench.placement());
                    }));
  }
}
