package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.List;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.text.Texts;

/** The File menu. For the event dispatch thread. */
final class FileMenu {
  private final EnricherWindow window;
  private final JMenu menu = new JMenu(command("menu.file", "", () -> {}));
  private final JMenu recent = new JMenu(command("menu.recent", "", () -> {}));
  private final MenuAction back;
  private final JCheckBoxMenuItem review =
      new JCheckBoxMenuItem(command("menu.review", "", () -> {}));

  /** The commands that need an open scene. */
  private final List<MenuAction> ofScene;

  FileMenu(EnricherWindow window, RunCommands runs, EnricherSettings settings) {
    this.window = window;
    back = new MenuAction(Texts.of("run.backnone"), "alt LEFT", runs::back);
    MenuAction save = command("menu.save", "ctrl S", window.saves()::save);
    MenuAction saveAs = command("menu.saveas", "ctrl shift S", window.saves()::saveAs);
    MenuAction changes = command("menu.changes", "ctrl D", window.saves()::showChanges);
    MenuAction merge = command("merge.command", "ctrl shift D", window.saves()::merge);
    MenuAction revert =
        command("window.revert.command", "", () -> window.saves().revert(window.opening()::reload));
    MenuAction allow = command("access.command", "", window.files()::allow);
    MenuAction pack = command("package.command", "", window.files()::packageScene);
    MenuAction imports = command("import.command", "ctrl shift E", window.imports()::choose);
    ofScene = List.of(save, saveAs, pack, imports, changes, merge, revert, allow);
    menu.add(command("create.command", "ctrl N", window.files()::newScene));
    menu.add(command("menu.open", "ctrl O", window.opening()::chooseAndOpen));
    menu.add(command("window.opennew", "ctrl shift O", window.files()::openInNewWindow));
    recent.addMenuListener(new MenuOpeningListener(this::listRecent));
    menu.add(recent);
    menu.add(command("run.inline", "ctrl I", runs::openInline));
    menu.add(command("run.inlinewindow", "ctrl shift I", runs::openInlineInWindow));
    menu.add(back);
    menu.add(command("menu.kept", "", window.opening()::askAboutKept));
    menu.addSeparator();
    menu.add(save);
    menu.add(saveAs);
    menu.add(pack);
    menu.add(changes);
    review.setSelected(settings.flag("review", true));
    review.addActionListener(event -> settings.put("review", review.isSelected()));
    menu.add(review);
    menu.add(merge);
    menu.add(revert);
    menu.addSeparator();
    menu.add(imports);
    menu.add(allow);
    menu.addSeparator();
    menu.add(command("menu.close", "ctrl Q", window::close));
  }

  private static MenuAction command(String text, String key, Runnable work) {
    return new MenuAction(Texts.of(text), key, work);
  }

  private void listRecent() {
    recent.removeAll();
    List<Path> files = window.recent().list();
    for (Path file : files) {
      recent.add(
          new MenuAction(
              file.getFileName() + "  (" + file.getParent() + ")", "", () -> window.open(file)));
    }
    if (files.isEmpty()) {
      recent.add(Texts.of("menu.none")).setEnabled(false);
    }
  }

  JMenu menu() {
    return menu;
  }

  /**
   * Names the scene that Back goes to.
   *
   * @param from empty for none
   */
  void back(String from) {
    back.rename(from.isEmpty() ? Texts.of("run.backnone") : Texts.of("run.back", from));
    back.setEnabled(!from.isEmpty());
  }

  /** Whether changes are shown before they are saved. */
  boolean reviews() {
    return review.isSelected();
  }

  /** Enables the commands that are possible now. */
  void refresh() {
    boolean open = window.session().isPresent();
    ofScene.forEach(command -> command.setEnabled(open));
  }
}
