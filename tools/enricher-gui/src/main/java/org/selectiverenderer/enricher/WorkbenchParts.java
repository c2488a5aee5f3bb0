package org.selectiverenderer.enricher;

import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.authoring.geometry.RepeatedPointsCheck;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.GridSetting;
import org.selectiverenderer.enricher.area.NameDialog;
import org.selectiverenderer.enricher.area.NamePrompt;
import org.selectiverenderer.enricher.cost.BudgetFileLocator;
import org.selectiverenderer.enricher.cost.CostPanel;
import org.selectiverenderer.enricher.form.FormPanel;
import org.selectiverenderer.enricher.help.HelpPanel;
import org.selectiverenderer.enricher.overview.OverviewPanel;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.plan.PlanPanel;
import org.selectiverenderer.enricher.preview.PreviewPanel;
import org.selectiverenderer.enricher.preview.VersionImageRenderer;
import org.selectiverenderer.enricher.problems.ProblemsPanel;
import org.selectiverenderer.enricher.problems.ValidatorCheck;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.Autosave;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.SettingsTrust;
import org.selectiverenderer.enricher.source.SourcePanel;
import org.selectiverenderer.enricher.tree.SceneTreePanel;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * The views of one document, made one after another, each in an event of its own: all of them take
 * a second the first time, in which the window would not react. For the event dispatch thread.
 */
final class WorkbenchParts {
  final EnricherSession session;
  final ViewTabs tabs = new ViewTabs();
  final Part<PreviewPanel> preview;
  final Part<ProblemsPanel> problems;
  final Part<SceneTreePanel> tree;
  final Part<SourcePanel> source;
  final Part<FormPanel> form;
  final Part<OverviewPanel> overview;
  final Part<CostPanel> cost;
  final Part<PlanPanel> plan;
  final Part<HelpPanel> help;
  final Part<AreaCommands> areas;
  final GridSetting grid;
  final HandleSettings handles = new HandleSettings();
  final VersionImageRenderer pictures;
  final Autosave autosave;

  /** The parts that are to be made. */
  private final Deque<Part<?>> left = new ArrayDeque<>();

  /** The actions that end the parts made so far; the last part ends first. */
  private final Deque<Runnable> disposals = new ArrayDeque<>();

  private boolean disposed;

  /** A view that is made when it is first asked for. */
  final class Part<T> {
    private final Supplier<T> making;
    private final Consumer<T> disposal;
    private @Nullable T made;

    private Part(Supplier<T> making, Consumer<T> disposal) {
      this.making = making;
      this.disposal = disposal;
      left.add(this);
    }

    T get() {
      T known = made;
      if (known == null) {
        T fresh = making.get();
        disposals.push(() -> disposal.accept(fresh));
        made = fresh;
        known = fresh;
      }
      return known;
    }
  }

  /**
   * @param trust asks what the settings file beside the scene may open
   */
  WorkbenchParts(
      EnricherSession session,
      EnricherSettings settings,
      CrashRecovery recovery,
      SettingsTrust trust) {
    this.session = session;
    grid = new GridSetting(settings);
    pictures = new VersionImageRenderer(() -> asScene(session));
    disposals.push(pictures::close);
    autosave = new Autosave(session, recovery);
    disposals.push(autosave::dispose);
    BudgetFileLocator budgets =
        new BudgetFileLocator(
            () -> session.file().path(),
            settings,
            (read, found) -> trust.limited(read, found, this::settingsAreOther));
    // First, as it loads the scene while the others are made.
    preview = new Part<>(() -> new PreviewPanel(session), PreviewPanel::dispose);
    problems = new Part<>(() -> problems(budgets), ProblemsPanel::dispose);
    tree = new Part<>(this::tree, SceneTreePanel::dispose);
    source = new Part<>(() -> new SourcePanel(session), SourcePanel::dispose);
    form = new Part<>(() -> new FormPanel(session, pictures), FormPanel::dispose);
    overview = new Part<>(() -> new OverviewPanel(session), OverviewPanel::dispose);
    cost = new Part<>(() -> cost(budgets), CostPanel::dispose);
    help = new Part<>(() -> new HelpPanel(session), HelpPanel::dispose);
    NamePrompt names = new NameDialog(tabs::component);
    areas = new Part<>(() -> areas(names), made -> {});
    plan = new Part<>(() -> plan(names), PlanPanel::dispose);
  }

  private ProblemsPanel problems(BudgetFileLocator budgets) {
    ValidatorCheck validator = validator(session, budgets);
    return new ProblemsPanel(
        session,
        List.of(validator, validator.graded(RepeatedPointsCheck.RULE, new RepeatedPointsCheck())));
  }

  private SceneTreePanel tree() {
    return new SceneTreePanel(session, problems.get()::faulty);
  }

  private CostPanel cost(BudgetFileLocator budgets) {
    return new CostPanel(session, budgets, problems.get()::checkAgain);
  }

  private AreaCommands areas(NamePrompt names) {
    return new AreaCommands(session, preview.get().probe(), names);
  }

  private PlanPanel plan(NamePrompt names) {
    return new PlanPanel(session, areas.get(), names, grid, handles);
  }

  private void settingsAreOther() {
    cost.get().lookAtFilesAgain();
    problems.get().checkAgain();
  }

  /** Returns the content access of version files: that of the scene that they belong to. */
  private static ContentAccessPolicy asScene(EnricherSession session) {
    Path folder = session.file().path().toAbsolutePath().resolveSibling("");
    List<Path> folders = new ArrayList<>(session.access().folders());
    folders.add(folder);
    folders.add(folder.resolveSibling(UrlResolver.INLINE_FOLDER));
    return new ContentAccessPolicy(folders, session.access().network());
  }

  private static ValidatorCheck validator(EnricherSession session, BudgetFileLocator budgets) {
    return new ValidatorCheck(
        () -> session.file().path(),
        RuleCatalogue.standard(),
        problems ->
            budgets
                .settings(problems)
                .map(read -> read.allowing(read.access().and(session.access()))));
  }

  /**
   * Makes all parts, one in each event, unless they are disposed of meanwhile.
   *
   * @param made runs in the event after the last
   */
  void make(Runnable made) {
    EventQueue.invokeLater(
        () -> {
          if (disposed) {
            return;
          }
          Part<?> next = left.poll();
          if (next == null) {
            made.run();
          } else {
            next.get();
            make(made);
          }
        });
  }

  /** Ends all parts that have been made, and the session. */
  void dispose() {
    disposed = true;
    while (!disposals.isEmpty()) {
      disposals.pop().run();
    }
    session.dispose();
  }
}
