package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.selectiverenderer.document.UndoHistory;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.Theme;
import org.selectiverenderer.enricher.text.Texts;

/** The menus: all that can be done, with its keys. */
final class WindowMenus {
  private final EnricherWindow window;
  private final SceneDialogs dialogs;
  private final EnricherSettings settings;
  private final JMenuBar bar = new JMenuBar();
  private final JMenu recent = new JMenu("Open Recent");
  private final JCheckBoxMenuItem review = new JCheckBoxMenuItem("Show Changes Before Saving");
  private final Command save;
  private final Command saveAs;
  private final Command changes;
  private final Command merge;
  private final Command undo;
  private final Command redo;

  WindowMenus(EnricherWindow window, SceneDialogs dialogs, EnricherSettings settings) {
    this.window = window;
    this.dialogs = dialogs;
    this.settings = settings;
    save = new Command("&Save", "ctrl S", window::save);
    saveAs = new Command("Save &As...", "ctrl shift S", window::saveAs);
    merge = new Command(Texts.of("merge.command"), "ctrl shift D", window::merge);
    changes = new Command("Show &Changes...", "ctrl D", window::showChanges);
    undo = new Command("&Undo", "ctrl Z", window::undo);
    redo = new Command("&Redo", "ctrl shift Z", window::redo);
    bar.add(file());
    bar.add(edit());
    bar.add(scene());
    bar.add(view());
    bar.add(help());
  }

  private JMenu file() {
    JMenu menu = menu("File", 'F');
    menu.add(new Command("&Open...", "ctrl O", window::chooseAndOpen));
    recent.addMenuListener(new Opening(this::listRecent));
    menu.add(recent);
    menu.add(new Command("&Kept Changes...", "", window::askAboutKept));
    menu.addSeparator();
    menu.add(save);
    menu.add(saveAs);
    menu.add(changes);
    review.setMnemonic('B');
    review.setSelected(settings.flag("review", true));
    review.addActionListener(event -> settings.put("review", review.isSelected()));
    menu.add(review);
    menu.add(merge);
    menu.addSeparator();
    menu.add(new Command("&Close Window", "ctrl Q", window::close));
    return menu;
  }

  private JMenu edit() {
    JMenu menu = menu("Edit", 'E');
    menu.add(undo);
    menu.add(redo);
    menu.addSeparator();
    menu.add(new Command("&Search Nodes", "ctrl shift F", with(Workbench::searchTree)));
    menu.add(new Command("&Next Problem", "F8", with(Workbench::nextProblem)));
    menu.add(new Command("&Previous Problem", "shift F8", with(Workbench::previousProblem)));
    menu.add(new Command("&Fix Problem", "alt ENTER", with(Workbench::fixProblem)));
    return menu;
  }

  private JMenu scene() {
    JMenu menu = menu("Scene", 'S');
    menu.add(new Command("Import &Ratings...", "ctrl R", () -> dialogs.ratings(Optional.empty())));
    menu.add(new Command("Make &Versions...", "ctrl M", dialogs::versions));
    return menu;
  }

  private JMenu view() {
    JMenu menu = menu("View", 'V');
    menu.add(new Command("Pre&view", "ctrl 1", with(bench -> bench.showTab(0))));
    menu.add(new Command("S&chemas", "ctrl 2", with(bench -> bench.showTab(1))));
    menu.add(new Command("S&ource", "ctrl 3", with(bench -> bench.showTab(2))));
    menu.add(new Command("Next &Part of the Window", "F6", with(Workbench::nextPart)));
    menu.addSeparator();
    ButtonGroup group = new ButtonGroup();
    for (Theme theme : Theme.values()) {
      JRadioButtonMenuItem item = new JRadioButtonMenuItem(theme.title() + " Colours");
      item.setMnemonic(theme.title().charAt(0));
      item.setSelected(theme == Theme.of(settings.word("theme", "")));
      item.addActionListener(event -> window.use(theme));
      group.add(item);
      menu.add(item);
    }
    return menu;
  }

  private JMenu help() {
    JMenu menu = menu("Help", 'H');
    menu.add(new Command("&Terms and Steps", "F1", with(Workbench::showHelp)));
    return menu;
  }

  private static JMenu menu(String name, char letter) {
    JMenu menu = new JMenu(name);
    menu.setMnemonic(letter);
    return menu;
  }

  private Runnable with(Consumer<Workbench> work) {
    return () -> window.bench().ifPresent(work);
  }

  private record Opening(Runnable work) implements MenuListener {
    @Override
    public void menuSelected(MenuEvent e) {
      work.run();
    }

    @Override
    public void menuDeselected(MenuEvent e) {
      // stays as it is
    }

    @Override
    public void menuCanceled(MenuEvent e) {
      // stays as it is
    }
  }

  private void listRecent() {
    recent.removeAll();
    List<Path> files = window.recent().list();
    for (Path file : files) {
      recent.add(
          new Command(
              file.getFileName() + "  (" + file.getParent() + ")", "", () -> window.open(file)));
    }
    if (files.isEmpty()) {
      recent.add("none yet").setEnabled(false);
    }
  }

  JMenuBar bar() {
    return bar;
  }

  /** Whether the author wants to see the changes before they are saved. */
  boolean reviews() {
    return review.isSelected();
  }

  /** Shows what can be done now, and the names of what would be undone and redone. */
  void refresh() {
    boolean open = window.session().isPresent();
    Optional<UndoHistory> history = window.session().map(session -> session.document().history());
    save.setEnabled(open);
    saveAs.setEnabled(open);
    changes.setEnabled(open);
    merge.setEnabled(open);
    name(undo, "Undo", history.flatMap(UndoHistory::undoName));
    name(redo, "Redo", history.flatMap(UndoHistory::redoName));
  }

  private static void name(Command command, String verb, Optional<String> step) {
    command.rename(step.map(name -> verb + " " + name).orElse(verb));
    command.setEnabled(step.isPresent());
  }
}
