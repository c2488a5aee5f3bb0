package org.selectiverenderer.enricher;

import java.awt.event.KeyEvent;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import org.selectiverenderer.authoring.UndoHistory;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.GridSetting;
import org.selectiverenderer.enricher.insert.InsertCommands;
import org.selectiverenderer.enricher.menu.StructureCommands;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.Language;
import org.selectiverenderer.enricher.settings.Theme;
import org.selectiverenderer.enricher.source.SourcePanel;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.enricher.text.UndoStepNames;

/** The menu bar of the window, with the accelerator of each command. */
final class EnricherMenuBar {
  private final EnricherWindow window;
  private final SceneDialogs dialogs;
  private final RunCommands runs;
  private final EnricherSettings settings;
  private final JMenuBar bar = new JMenuBar();
  private final FileMenu file;
  private final UndoStepNames steps = new UndoStepNames();
  private final MenuAction undo;
  private final MenuAction redo;

  EnricherMenuBar(
      EnricherWindow window, SceneDialogs dialogs, RunCommands runs, EnricherSettings settings) {
    this.runs = runs;
    this.window = window;
    this.dialogs = dialogs;
    this.settings = settings;
    file = new FileMenu(window, runs, settings);
    undo = command("menu.undo", "ctrl Z", window::undo);
    redo = command("menu.redo", "ctrl shift Z", window::redo);
    bar.add(file.menu());
    bar.add(edit());
    bar.add(insert());
    bar.add(scene());
    bar.add(run());
    bar.add(view());
    bar.add(help());
  }

  private JMenu edit() {
    JMenu menu = menu("menu.edit");
    menu.add(undo);
    menu.add(redo);
    menu.addSeparator();
    menu.add(nodes("cut", "ctrl X", StructureCommands::cut));
    menu.add(nodes("copy", "ctrl C", StructureCommands::copy));
    menu.add(nodes("paste", "ctrl V", StructureCommands::paste));
    menu.add(nodes("delete", "DELETE", StructureCommands::delete));
    menu.add(
        command("node.duplicate", "", with(bench -> bench.nodes(StructureCommands::duplicate))));
    menu.addSeparator();
    menu.add(
        new MenuAction(Texts.of("overview.copy"), "ctrl alt C", with(Workbench::copyMetadata)));
    menu.add(
        new MenuAction(Texts.of("overview.paste"), "ctrl alt V", with(Workbench::pasteMetadata)));
    menu.addSeparator();
    menu.add(command("menu.search", "ctrl shift F", with(Workbench::searchTree)));
    menu.add(command("menu.next", "F8", with(Workbench::nextProblem)));
    menu.add(command("menu.previous", "shift F8", with(Workbench::previousProblem)));
    menu.add(command("menu.fix", "alt ENTER", with(Workbench::fixProblem)));
    source(menu);
    return menu;
  }

  private JMenu insert() {
    JMenu menu = menu("insert.menu");
    menu.add(command("insert.node", "ctrl shift N", with(Workbench::insertNode)));
    menu.addSeparator();
    for (String template : InsertCommands.TEMPLATES) {
      if (template.isEmpty()) {
        menu.addSeparator();
      } else {
        menu.add(command("insert." + template, "", with(bench -> bench.insert(template))));
      }
    }
    return menu;
  }

  private MenuAction nodes(String text, String key, Consumer<StructureCommands> work) {
    return command("node." + text, key, with(bench -> bench.edit(key, work)));
  }

  /** Adds the commands of the source view, which bring it into view. */
  private void source(JMenu menu) {
    menu.addSeparator();
    menu.add(sourceCommand("menuFind", "ctrl F", source -> source.find(false)));
    menu.add(sourceCommand("menuReplace", "ctrl H", source -> source.find(true)));
    menu.add(sourceCommand("menuNext", "F3", source -> source.findNext(1)));
    menu.add(sourceCommand("menuPrevious", "shift F3", source -> source.findNext(-1)));
    menu.add(sourceCommand("menuLine", "ctrl G", SourcePanel::goToLine));
    menu.add(sourceCommand("menuTag", "ctrl shift M", SourcePanel::goToMatchingTag));
    menu.add(sourceCommand("menuComment", "ctrl SLASH", SourcePanel::toggleComment));
  }

  private MenuAction sourceCommand(String text, String key, Consumer<SourcePanel> work) {
    return new MenuAction(Texts.of("source." + text), key, with(bench -> bench.inSource(work)));
  }

  private JMenu scene() {
    JMenu menu = menu("menu.scene");
    menu.add(command("menu.ratings", "ctrl R", () -> dialogs.ratings(Optional.empty())));
    menu.add(command("menu.versions", "ctrl M", dialogs::versions));
    menu.add(command("menu.versions.many", "", dialogs::manyVersions));
    menu.add(command("menu.images", "", dialogs::images));
    menu.add(command("menu.routes", "", dialogs::routes));
    areas(menu);
    return menu;
  }

  private JMenu run() {
    JMenu menu = menu("run.menu");
    menu.add(new MenuAction(Texts.of("run.run"), "F5", runs::run));
    menu.add(new MenuAction(Texts.of("run.runas"), "shift F5", runs::runAs));
    menu.add(new MenuAction(Texts.of("run.shown"), "", runs::showMessages));
    menu.addSeparator();
    menu.add(new MenuAction(Texts.of("run.studies"), "", runs::openStudies));
    return menu;
  }

  /** Adds the commands for areas, Switches and any selected node. */
  private void areas(JMenu menu) {
    menu.addSeparator();
    menu.add(area("add", "ctrl shift A", AreaCommands::addAroundSelection));
    menu.add(area("switch", "ctrl shift W", AreaCommands::makeSwitch));
    menu.add(area("rename.node", "F2", AreaCommands::rename));
    menu.add(ArrangeMenu.of(window));
    JMenu grid = menu("area.grid");
    grid.addMenuListener(new MenuOpeningListener(() -> listGrid(grid)));
    menu.add(grid);
  }

  private MenuAction area(String key, String stroke, Consumer<AreaCommands> does) {
    return new MenuAction(
        Texts.of("area." + key),
        stroke,
        with(
            bench -> {
              bench.commit();
              does.accept(bench.areas());
            }));
  }

  private void listGrid(JMenu menu) {
    GridSetting grid = new GridSetting(settings);
    menu.removeAll();
    for (double step : GridSetting.STEPS) {
      JRadioButtonMenuItem item = new JRadioButtonMenuItem(GridSetting.title(step));
      item.setSelected(step == grid.step().step());
      item.addActionListener(event -> grid.use(step));
      menu.add(item);
    }
  }

  private JMenu view() {
    JMenu menu = menu("menu.view");
    menu.add(command("menu.preview", "ctrl 1", with(bench -> bench.showTab(0))));
    menu.add(command("menu.schemas", "ctrl 2", with(bench -> bench.showTab(1))));
    menu.add(command("menu.source", "ctrl 3", with(bench -> bench.showTab(2))));
    menu.add(new MenuAction(Texts.of("area.plan"), "ctrl 4", with(bench -> bench.showTab(3))));
    menu.add(command("menu.part", "F6", with(Workbench::nextPart)));
    menu.addSeparator();
    ButtonGroup group = new ButtonGroup();
    for (Theme theme : Theme.values()) {
      JRadioButtonMenuItem item = new JRadioButtonMenuItem(command(theme.text(), "", () -> {}));
      item.setSelected(theme == Theme.of(settings.word("theme", "")));
      item.addActionListener(event -> window.look().use(theme));
      group.add(item);
      menu.add(item);
    }
    menu.addSeparator();
    menu.add(command("window.larger", "ctrl PLUS", () -> window.say(window.look().zoom(1))));
    menu.add(command("window.smaller", "ctrl MINUS", () -> window.say(window.look().zoom(-1))));
    menu.add(command("window.usual", "ctrl 0", () -> window.say(window.look().zoom(0))));
    menu.addSeparator();
    menu.add(languages());
    return menu;
  }

  private JMenu languages() {
    JMenu menu = menu("window.languages");
    ButtonGroup group = new ButtonGroup();
    for (Language language : Language.values()) {
      String title =
          language == Language.SYSTEM ? Texts.of("window.systemlanguage") : language.title();
      JRadioButtonMenuItem item = new JRadioButtonMenuItem(title);
      item.setMnemonic(KeyEvent.getExtendedKeyCodeForChar(title.charAt(0)));
      item.setSelected(language == Language.of(settings));
      item.addActionListener(event -> window.say(window.look().use(language)));
      group.add(item);
      menu.add(item);
    }
    return menu;
  }

  /** Creates an action whose text and mnemonic are in the resource bundles. */
  private static MenuAction command(String text, String key, Runnable work) {
    return new MenuAction(Texts.of(text), key, work);
  }

  /** Registers alternative zoom keys for keyboards where plus and minus are elsewhere. */
  void moreKeys(JRootPane root) {
    Map<String, Integer> steps =
        Map.of("ctrl EQUALS", 1, "ctrl shift EQUALS", 1, "ctrl ADD", 1, "ctrl SUBTRACT", -1);
    steps.forEach(
        (key, step) ->
            root.registerKeyboardAction(
                event -> window.say(window.look().zoom(step)),
                KeyStroke.getKeyStroke(key),
                JComponent.WHEN_IN_FOCUSED_WINDOW));
  }

  private JMenu help() {
    JMenu menu = menu("menu.help");
    menu.add(command("menu.terms", "F1", with(Workbench::showHelp)));
    menu.add(command("window.keys", "shift F1", window::showKeys));
    menu.add(command("window.about", "", window::showAbout));
    return menu;
  }

  private static JMenu menu(String text) {
    return new JMenu(command(text, "", () -> {}));
  }

  private Runnable with(Consumer<Workbench> work) {
    return () -> window.bench().ifPresent(work);
  }

  JMenuBar bar() {
    return bar;
  }

  /** Whether changes are shown before they are saved. */
  boolean reviews() {
    return file.reviews();
  }

  /**
   * Enables the commands that are possible now, and names the steps that Undo and Redo would act
   * on.
   */
  void refresh() {
    Optional<UndoHistory> history = window.session().map(session -> session.document().history());
    file.refresh();
    String from = runs.from().map(file -> String.valueOf(file.getFileName())).orElse("");
    file.back(from);
    name(undo, "menu.undo", history.flatMap(UndoHistory::undoName).map(steps::shown));
    name(redo, "menu.redo", history.flatMap(UndoHistory::redoName).map(steps::shown));
  }

  private static void name(MenuAction command, String text, Optional<String> step) {
    String verb = MnemonicText.of(Texts.of(text)).words();
    command.rename(step.map(name -> verb + " " + name).orElse(verb));
    command.setEnabled(step.isPresent());
  }
}
