package org.selectiverenderer.enricher;

import java.awt.Toolkit;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;
import org.selectiverenderer.authoring.structure.ChildPosition;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.DuplicateShifts;
import org.selectiverenderer.enricher.component.CollapsibleSplit;
import org.selectiverenderer.enricher.cost.CostPanel;
import org.selectiverenderer.enricher.form.FormPanel;
import org.selectiverenderer.enricher.help.HelpPanel;
import org.selectiverenderer.enricher.insert.InsertCommands;
import org.selectiverenderer.enricher.menu.NodeCommand;
import org.selectiverenderer.enricher.menu.NodeEditCommands;
import org.selectiverenderer.enricher.menu.NodeMenu;
import org.selectiverenderer.enricher.menu.StructureCommands;
import org.selectiverenderer.enricher.overview.MetadataClipboard;
import org.selectiverenderer.enricher.placement.PlacementCommands;
import org.selectiverenderer.enricher.plan.PlanPanel;
import org.selectiverenderer.enricher.preview.PreviewPanel;
import org.selectiverenderer.enricher.problems.ProblemCounts;
import org.selectiverenderer.enricher.problems.ProblemsPanel;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.Autosave;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.source.SourcePanel;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.enricher.tree.NodeDrop;
import org.selectiverenderer.enricher.tree.SceneTreePanel;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** All views of one open document, laid out as the author left them. */
final class Workbench {
  private static final Set<String> FORMS = Set.of("Switch", "ProximitySensor");

  /** Height in pixels of the polygons and limits below the table of schemas. */
  private static final int COSTS = 300;

  /** Height in pixels of the views in which both have room. */
  private static final int BOTH = 700;

  /** Least width in pixels of the views. */
  private static final int VIEWS = 120;

  private final WorkbenchParts parts;
  private final EnricherSession session;
  private final EnricherSettings settings;
  private final Autosave autosave;
  private final SceneTreePanel tree;
  private final SourcePanel source;
  private final FormPanel form;
  private final PreviewPanel preview;
  private final CostPanel cost;
  private final JSplitPane schemas;
  private final CollapsibleSplit schemasAndCosts;
  private final AreaCommands areas;
  private final PlacementCommands placement;
  private final PlanPanel plan;
  private final HelpPanel help;
  private final ProblemsPanel problems;
  private final ViewTabs tabs;
  private final JSplitPane left;
  private final JSplitPane right;
  private final JSplitPane all;
  private final NodeMenu menu;
  private final StructureCommands structure;
  private final FocusedKeys focused;
  private final InsertCommands insert;

  /**
   * @param parts its views; those that are not made yet are made now
   * @param counts called with the number of problems whenever it changes
   * @param makeVersions opens the versions dialog for an element with a DEF name
   */
  Workbench(
      WorkbenchParts parts,
      EnricherSettings settings,
      Consumer<ProblemCounts> counts,
      Consumer<DocumentElement> makeVersions) {
    this.parts = parts;
    this.session = parts.session;
    this.settings = settings;
    tabs = parts.tabs;
    preview = parts.preview.get();
    menu = new NodeMenu(session);
    structure = new StructureCommands(session, Toolkit.getDefaultToolkit().getSystemClipboard());
    autosave = parts.autosave;
    problems = parts.problems.get();
    tree = parts.tree.get();
    problems.onCounts(
        now -> {
          tree.tree().repaint();
          counts.accept(now);
        });
    problems.onPlace(this::revealInSource);
    problems.onExplain(this::explain);
    source = parts.source.get();
    form = parts.form.get();
    form.onMakeVersions(makeVersions);
    form.follow(problems);
    help = parts.help.get();
    cost = parts.cost.get();
    schemas = split(JSplitPane.VERTICAL_SPLIT, parts.overview.get(), cost, 1, "polygons");
    schemasAndCosts =
        new CollapsibleSplit(
            schemas,
            Texts.of("cost.name"),
            Texts.of("cost.fold"),
            open -> settings.put("costs", open));
    areas = parts.areas.get();
    preview.grid(parts.grid::step);
    preview.handles(parts.handles);
    placement = new PlacementCommands(session, preview.probe());
    preview.addAction(
        Texts.of("area.add.short"), Texts.of("area.add.tip"), areas::addAroundSelection);
    plan = parts.plan.get();
    tabs.add("Preview", Texts.of("window.tab.preview"), preview);
    tabs.add("Schemas", Texts.of("window.tab.schemas"), schemasAndCosts);
    tabs.add("Source", Texts.of("window.tab.source"), source.component());
    tabs.add("Plan", Texts.of("area.plan"), plan);
    tabs.add("Help", Texts.of("window.tab.help"), help);
    right = split(JSplitPane.HORIZONTAL_SPLIT, tabs.component(), form, 1, "form");
    left = split(JSplitPane.HORIZONTAL_SPLIT, tree.component(), right, 0, "tree");
    all = split(JSplitPane.VERTICAL_SPLIT, left, problems, 1, "problems");
    focused = new FocusedKeys(all, List.of(tree.component(), preview, plan));
    addMenus(makeVersions);
    addTreeKeys();
    structure.shifts(new DuplicateShifts(preview.probe()));
    insert = new InsertCommands(session, structure, this::here, preview::placeAhead);
    insert.onInserted(tree::reveal);
    tabs.select(settings.word("tab", ""));
    if (session.document().fault().isPresent()) {
      tabs.bringToFront(source.component());
      source.showFault();
    }
  }

  private void addMenus(Consumer<DocumentElement> makeVersions) {
    MetadataClipboard metadata = new MetadataClipboard(session);
    menu.add(NodeEditCommands.of(session, structure));
    menu.add(
        new NodeCommand(
            "duplicateNode",
            Texts.of("node.duplicate"),
            "ctrl D",
            element -> structure.removable(),
            element -> nodes(StructureCommands::duplicate)));
    menu.add(
        new NodeCommand(
            "insertNode",
            Texts.of("insert.here"),
            "INSERT",
            element -> session.document().locked().isEmpty(),
            element -> insertNode()));
    menu.add(areas.commands(this::commit));
    menu.add(placement.commands());
    menu.add(
        List.of(
            new NodeCommand(
                "makeVersions",
                Texts.of("menu.versions"),
                element -> SceneDialogs.object(element).isPresent(),
                element -> SceneDialogs.object(element).ifPresent(makeVersions)),
            new NodeCommand(
                "copyMetadata",
                Texts.of("overview.copy"),
                metadata::fits,
                element -> copyMetadata()),
            new NodeCommand(
                "pasteMetadata",
                Texts.of("overview.paste"),
                element -> metadata.fits(element) && session.document().locked().isEmpty(),
                element -> pasteMetadata())));
    menu.add(
        List.of(
            new NodeCommand(
                "goToSource", Texts.of("node.toSource"), element -> true, this::showInSource)));
    menu.attach(tree.tree());
    preview.onMenu(menu::show);
    source.onMenu(menu::fill);
  }

  private void addTreeKeys() {
    key("ctrl X", "node.cut", StructureCommands::cut);
    key("ctrl C", "node.copy", StructureCommands::copy);
    key("ctrl V", "node.paste", StructureCommands::paste);
    key("DELETE", "node.delete", StructureCommands::delete);
    key("ctrl D", "node.duplicate", StructureCommands::duplicate);
    key("alt UP", "node.up", each -> each.step(false));
    key("alt DOWN", "node.down", each -> each.step(true));
    tree.onKey("INSERT", MnemonicText.of(Texts.of("insert.here")).words(), this::insertNode);
    tree.onKey("F2", MnemonicText.of(Texts.of("area.rename.node")).words(), this::renameNode);
    tree.onDrop(
        new NodeDrop() {
          @Override
          public Optional<String> complaint(
              List<DocumentElement> nodes, ChildPosition position, boolean copy) {
            return structure.complaint(nodes, position, copy);
          }

          @Override
          public void drop(List<DocumentElement> nodes, ChildPosition position, boolean copy) {
            commit();
            structure.drop(nodes, position, copy);
          }
        });
  }

  private void key(String key, String text, Consumer<StructureCommands> work) {
    tree.onKey(key, MnemonicText.of(Texts.of(text)).words(), () -> nodes(work));
  }

  private void renameNode() {
    commit();
    areas.rename();
  }

  /** Does something with the selected nodes. */
  void nodes(Consumer<StructureCommands> work) {
    commit();
    work.accept(structure);
  }

  /** Inserts a template at the selection. */
  void insert(String template) {
    commit();
    insert.insert(template, all);
  }

  /** Asks for a node to be inserted at the selection. */
  void insertNode() {
    commit();
    insert.choose(all);
  }

  /** Does what a key does where the focus is, in a text for example, else acts on the nodes. */
  void edit(String key, Consumer<StructureCommands> work) {
    KeyStroke stroke = KeyStroke.getKeyStroke(key);
    if (focused.elsewhere(stroke)) {
      session.message(Texts.of("node.elsewhere"));
    } else if (!focused.act(stroke)) {
      nodes(work);
    }
  }

  /**
   * The context menu of the selected node in all views; other parts of the window add commands to
   * it.
   */
  NodeMenu menu() {
    return menu;
  }

  private void showInSource(DocumentElement element) {
    inSource(panel -> panel.reveal(element.start()));
    source.area().requestFocusInWindow();
  }

  private static JSplitPane split(
      int direction, JComponent one, JComponent other, double weight, String name) {
    JSplitPane split = new JSplitPane(direction, true, one, other);
    split.setResizeWeight(weight);
    split.setBorder(null);
    for (String key : List.of("F6", "F8")) {
      split
          .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
          .put(KeyStroke.getKeyStroke(key), "none"); // left to the window's menus
    }
    split.setName(name);
    split.getAccessibleContext().setAccessibleName(Texts.of("window.border." + name));
    return split;
  }

  JComponent component() {
    return all;
  }

  EnricherSession session() {
    return session;
  }

  /** Places the dividers where the author left them, once the window has its size. */
  void layOut(int width, int height) {
    left.setDividerLocation(settings.number("split.tree", Math.min(230, width / 4)));
    int rest = width - left.getDividerLocation() - left.getDividerSize();
    int form = settings.number("split.form", Math.min(375, rest / 2));
    right.setDividerLocation(Math.max(VIEWS, rest - form));
    int views = height - settings.number("split.problems", Math.min(130, height / 4));
    schemas.setDividerLocation(settings.number("split.cost", Math.max(100, views - COSTS)));
    schemasAndCosts.open(settings.flag("costs", views >= BOTH));
    all.setDividerLocation(
        Math.max(120, height - settings.number("split.problems", Math.min(130, height / 4))));
  }

  /** Stores the divider locations and the selected tab in the settings. */
  void remember() {
    settings.put("tab", tabs.selectedName());
    settings.put("split.tree", left.getDividerLocation());
    settings.put("split.form", right.getWidth() - right.getDividerLocation());
    settings.put("split.cost", schemas.getDividerLocation());
    settings.put("split.problems", all.getHeight() - all.getDividerLocation());
  }

  /** Commits what is being typed in source or form to the document. */
  void commit() {
    source.endStep();
    form.commit();
  }

  /** Shows the explanation of a validator rule in the help; without a rule, the help itself. */
  private void explain(Optional<String> rule) {
    rule.flatMap(RuleCatalogue.standard()::find).ifPresent(help::explain);
    showHelp();
  }

  /** Sets what opens another file in which a problem is. */
  void onElsewhere(Consumer<SourceLocation> open) {
    problems.onElsewhere(open);
  }

  /**
   * Puts the caret of the source at an offset, and shows the source if the selected node has no
   * form.
   */
  private void revealInSource(int offset) {
    session.selection().ifPresent(tree::reveal);
    source.reveal(offset);
    boolean inForm =
        session.selection().map(DocumentElement::name).filter(FORMS::contains).isPresent();
    if (!inForm) {
      tabs.bringToFront(source.component());
    }
  }

  /** Finds the places onto which models are dropped. */
  ModelDropTarget drops() {
    return new ModelDropTarget(preview, plan, tree.component());
  }

  /** The commands for areas, Switches and nodes. */
  AreaCommands areas() {
    return areas;
  }

  /** The commands that place selected nodes. */
  PlacementCommands placement() {
    return placement;
  }

  /** Reads the version files again, which may have changed although the document has not. */
  void lookAtFilesAgain() {
    preview.reload();
    cost.lookAtFilesAgain();
  }

  /** Reads the scene and its files again, as it may read from other folders and hosts now. */
  void accessChanged() {
    lookAtFilesAgain();
    problems.checkAgain();
  }

  /** The viewer's pose in the preview; empty while there is none. */
  Optional<Pose> here() {
    return preview.pose();
  }

  /** Puts the focus on the source if it is not well formed, else on the tree. */
  void focus() {
    boolean broken = session.document().fault().isPresent();
    (broken ? source.area() : tree.tree()).requestFocusInWindow();
  }

  void searchTree() {
    tree.searchField().requestFocusInWindow();
    tree.searchField().selectAll();
  }

  /** Copies the whole metadata of the selected object or area. */
  void copyMetadata() {
    commit();
    new MetadataClipboard(session).copy(session.selection().stream().toList());
  }

  /** Pastes copied metadata to the selected object or area. */
  void pasteMetadata() {
    commit();
    new MetadataClipboard(session).paste(session.selection().stream().toList());
  }

  void nextProblem() {
    problems.next();
  }

  void previousProblem() {
    problems.previous();
  }

  void fixProblem() {
    problems.fix();
  }

  /** Shows a view and gives it the focus, so that its keys work at once. */
  void showTab(int index) {
    tabs.show(index);
  }

  /** Brings the source into view and does something with it. */
  void inSource(Consumer<SourcePanel> work) {
    if (tabs.bringToFront(source.component())) {
      source.area().requestFocusInWindow();
    }
    work.accept(source);
  }

  void showHelp() {
    tabs.bringToFront(help); // The focus says what is explained.
  }

  /** Moves the focus to the next pane: tree, view, form, problems. */
  void nextPart() {
    new FocusCycler(List.of(tree.component(), tabs.selected(), form, problems)).next();
  }

  /** The OpenGL renderer of the preview; empty while it is not known. */
  Optional<String> drawnBy() {
    return preview.drawnBy();
  }

  Autosave autosave() {
    return autosave;
  }

  void dispose() {
    focused.dispose();
    parts.dispose();
  }
}
