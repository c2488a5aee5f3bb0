package org.selectiverenderer.enricher.cost;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.IncrementalSceneCounter.CountResult;
import org.selectiverenderer.polygon.PolygonContributions;
import org.selectiverenderer.polygon.RenderingCost;
import org.selectiverenderer.polygon.SceneStatistics;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CostKind;
import org.selectiverenderer.validation.budget.BudgetStatus;
import org.selectiverenderer.validation.settings.BudgetSettingsEditor;

/**
 * A row of the cost table: a part of the scene in a state of its Switches; a value.
 *
 * @param scope DEF of the group; empty for the whole scene
 * @param schemas active schemas of the state; none for {@code ALL} and {@code WORST}
 * @param percent share of all polygons of the part; negative where unknown
 * @param cost what it costs beside polygons; of {@code WORST} the most of each
 * @param limit the budget in the settings file
 * @param statuses whether its limits are kept
 * @param limitable whether a limit can be set for this row
 * @param shares how many polygons each object contributes
 */
record CostRow(
    String scope,
    Kind kind,
    List<String> schemas,
    long polygons,
    double percent,
    RenderingCost cost,
    Optional<CostBudget> limit,
    List<BudgetStatus> statuses,
    boolean limitable,
    Optional<PolygonContributions> shares) {
  /** The kind of state. */
  enum Kind {
    /** All objects at their most detailed. */
    ALL,
    LOADED,
    STATE,
    /** The state with the most polygons that a viewer can reach. */
    WORST
  }

  /**
   * The budget for this row with a limit. One for every scene stays one.
   *
   * @param file the scene's file as budgets name it
   */
  CostBudget budget(String file, long most) {
    return new CostBudget(limit.map(CostBudget::file).orElse(file), scope, schemas, most);
  }

  /** Whether the limit of polygons is exceeded. */
  boolean broken() {
    return status().filter(BudgetStatus::broken).isPresent();
  }

  /** Whether the limit of polygons is kept; empty for none. */
  Optional<BudgetStatus> status() {
    return status(CostKind.POLYGONS);
  }

  Optional<BudgetStatus> status(CostKind kind) {
    return statuses.stream().filter(status -> status.kind() == kind).findFirst();
  }

  /** Whether another row is about the same part and state. */
  boolean same(CostRow other) {
    return kind == other.kind && scope.equals(other.scope) && schemas.equals(other.schemas);
  }

  /** Whether the row was there before and its limit not exceeded. A part may have two limits. */
  boolean held(List<CostRow> before) {
    List<CostRow> old = before.stream().filter(this::same).toList();
    return !old.isEmpty()
        && old.stream().noneMatch(row -> row.broken() && row.file().equals(file()));
  }

  private Optional<String> file() {
    return limit.map(CostBudget::file);
  }

  /**
   * Returns the rows of a scene: for each part full detail, as loaded, its states and the worst;
   * then limits that fit none of these.
   *
   * @param budgets those for the scene's file
   */
  static List<CostRow> of(CountResult counted, List<CostBudget> budgets) {
    Making making = new Making(counted.model(), new ArrayList<>(budgets));
    for (ScopeCount scope : counted.statistics().scopes()) {
      making.scope(
          scope,
          counted.states().stream().filter(state -> state.scope().equals(scope.scope())).toList());
    }
    making.rest();
    return List.copyOf(making.rows);
  }

  private record Making(EnrichmentPolygonModel model, List<CostBudget> left, List<CostRow> rows) {
    Making(EnrichmentPolygonModel model, List<CostBudget> budgets) {
      this(model, budgets, new ArrayList<>());
    }

    void scope(ScopeCount count, List<PolygonContributions> states) {
      String scope = count.scope().equals(SceneStatistics.WHOLE_SCENE) ? "" : count.scope();
      Optional<PolygonContributions> none = Optional.empty();
      if (count.high() > 0) {
        add(scope, Kind.ALL, List.of(), count.high(), 100, count.highCost(), none);
      }
      for (PolygonContributions state : states) {
        Kind kind = state == states.get(0) ? Kind.LOADED : Kind.STATE;
        add(
            scope,
            kind,
            state.schemas(),
            state.polygons(),
            state.percent(),
            state.cost(),
            Optional.of(state));
      }
      worst(scope, count.high(), states);
    }

    private void worst(String scope, long high, List<PolygonContributions> states) {
      List<EnrichmentPolygonModel.State> reached = model.states(scope);
      RenderingCost most =
          new RenderingCost(
              reached.stream().mapToLong(CostKind.DRAW_CALLS::of).max().orElse(0),
              reached.stream().mapToLong(CostKind.TEXTURE_BYTES::of).max().orElse(0));
      reached.stream()
          .max(Comparator.comparingLong(EnrichmentPolygonModel.State::polygons))
          .ifPresent(
              worst -> {
                Optional<PolygonContributions> shares =
                    states.stream().filter(state -> state.polygons() == worst.polygons()).findAny();
                double percent = high == 0 ? 0 : 100.0 * worst.polygons() / high;
                add(scope, Kind.WORST, List.of(), worst.polygons(), percent, most, shares);
              });
    }

    private void add(
        String scope,
        Kind kind,
        List<String> schemas,
        long polygons,
        double percent,
        RenderingCost cost,
        Optional<PolygonContributions> shares) {
      CostBudget wanted = new CostBudget(scope, schemas, 0);
      boolean limitable =
          kind != Kind.ALL
              && (kind == Kind.WORST || !schemas.isEmpty())
              && BudgetStatus.of(wanted, CostKind.POLYGONS, model)
                  .filter(status -> !status.worst().schemas().isEmpty() || kind != Kind.STATE)
                  .isPresent();
      Optional<CostBudget> limit =
          limitable
              ? left.stream()
                  .filter(budget -> BudgetSettingsEditor.same(budget, wanted))
                  // That of the file; one for every scene gets a row of its own then.
                  .min(Comparator.comparing(budget -> budget.file().isEmpty()))
              : Optional.empty();
      limit.ifPresent(left::remove);
      rows.add(
          new CostRow(
              scope,
              kind,
              schemas,
              polygons,
              percent,
              cost,
              limit,
              limit.map(this::statuses).orElse(List.of()),
              limitable,
              shares));
    }

    /** Adds the whole scene, if it is not counted as a part, and the remaining limits. */
    void rest() {
      if (rows.stream().noneMatch(row -> row.scope().isEmpty())) {
        worst("", 0, List.of());
        CostRow whole = rows.remove(rows.size() - 1);
        rows.add(whole.withoutPercent());
      }
      for (CostBudget budget : List.copyOf(left)) {
        List<BudgetStatus> found = statuses(budget);
        if (!found.isEmpty() && rows.stream().noneMatch(row -> row.limit(budget))) {
          EnrichmentPolygonModel.State worst = found.get(0).worst();
          rows.add(
              new CostRow(
                  budget.scope(),
                  budget.schemas().isEmpty() ? Kind.WORST : Kind.STATE,
                  budget.schemas(),
                  worst.polygons(),
                  -1,
                  worst.cost(),
                  Optional.of(budget),
                  found,
                  true,
                  Optional.empty()));
        }
      }
    }

    private List<BudgetStatus> statuses(CostBudget budget) {
      return Stream.of(CostKind.values())
          .flatMap(kind -> BudgetStatus.of(budget, kind, model).stream())
          .toList();
    }
  }

  private boolean limit(CostBudget budget) {
    return limit.equals(Optional.of(budget));
  }

  private CostRow withoutPercent() {
    return new CostRow(
        scope, kind, schemas, polygons, -1, cost, limit, statuses, limitable, shares);
  }
}
