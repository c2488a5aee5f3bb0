package org.selectiverenderer.bench.versions;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.budget.MultipleChoiceKnapsack;
import org.selectiverenderer.control.budget.VersionLoss;
import org.selectiverenderer.walkthrough.budget.ObjectPlaces;

/** A rule that chooses the versions of objects within a budget of triangles. */
enum VersionRule {
  /**
   * The distance from the viewer decides, as of an LOD node (X3D 4.0, 23.4.2), with ranges that
   * double and are the same for all objects. The first range is the longest that keeps the budget.
   */
  DISTANCE {
    @Override
    int[] choose(ObjectPlaces places, Viewer viewer, long budget) {
      return within(places, budget, range -> byDistance(places, viewer.position(), range));
    }
  },
  /**
   * The smallest version whose error, as large as it is seen, is below a threshold, which is the
   * smallest that keeps the budget.
   */
  SCREEN_ERROR {
    @Override
    int[] choose(ObjectPlaces places, Viewer viewer, long budget) {
      return within(places, budget, quality -> byError(places, viewer.position(), 1 / quality));
    }
  },
  /** The least loss, as if all objects were inconsistent. */
  LEAST_LOSS {
    @Override
    int[] choose(ObjectPlaces places, Viewer viewer, long budget) {
      return leastLoss(places, viewer, budget);
    }
  },
  /** The least loss, where objects that are consistent count less: what {@code --budget} does. */
  BUDGET {
    @Override
    int[] choose(ObjectPlaces places, Viewer viewer, long budget) {
      places.readConsistency();
      return leastLoss(places, viewer, budget);
    }
  };

  private interface Chooser {
    /**
     * @param quality the higher, the more triangles
     */
    int[] choose(double quality);
  }

  /** Returns the name in reports. */
  String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /**
   * Returns the version of each object.
   *
   * @param places of the objects, which no other rule uses
   * @param budget triangles of the objects together; where even the cheapest versions have more,
   *     these are chosen
   */
  abstract int[] choose(ObjectPlaces places, Viewer viewer, long budget);

  private static int[] leastLoss(ObjectPlaces places, Viewer viewer, long budget) {
    MultipleChoiceKnapsack problem = new MultipleChoiceKnapsack(places.choices(), 0);
    places.weigh(viewer, Optional.empty(), problem::weigh);
    problem.solve(budget);
    return IntStream.range(0, problem.size()).map(problem::choice).toArray();
  }

  /** Returns the triangles of the objects together. */
  static long cost(ObjectPlaces places, int[] choices) {
    return IntStream.range(0, choices.length).mapToLong(i -> places.cost(i, choices[i])).sum();
  }

  private static int[] within(ObjectPlaces places, long budget, Chooser chooser) {
    double low = -40; // Powers of two: of metres, or of one over an angle.
    double high = 40;
    for (int step = 0; step < 60; step++) {
      double middle = (low + high) / 2;
      if (cost(places, chooser.choose(Math.pow(2, middle))) <= budget) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return chooser.choose(Math.pow(2, low));
  }

  private static int[] byDistance(ObjectPlaces places, Vector3dc eye, double range) {
    int[] chosen = new int[places.choices().size()];
    for (int object = 0; object < chosen.length; object++) {
      List<Integer> finest = finestFirst(places, object);
      double distance = places.distance(object, eye);
      int level = 0;
      while (level < finest.size() - 1 && distance >= range * (1 << level)) {
        level++;
      }
      chosen[object] = finest.get(level);
    }
    return chosen;
  }

  private static int[] byError(ObjectPlaces places, Vector3dc eye, double threshold) {
    int[] chosen = new int[places.choices().size()];
    for (int object = 0; object < chosen.length; object++) {
      List<Integer> finest = finestFirst(places, object);
      double seen = places.radius(object) / places.distance(object, eye);
      int level = finest.size() - 1;
      while (level > 0 && seen * error(places, object, finest.get(level)) > threshold) {
        level--;
      }
      chosen[object] = finest.get(level);
    }
    return chosen;
  }

  private static double error(ObjectPlaces places, int object, int version) {
    return VersionLoss.ofTriangles(places.cost(object, version));
  }

  private static List<Integer> finestFirst(ObjectPlaces places, int object) {
    return IntStream.range(0, places.choices().get(object).costs().size())
        .boxed()
        .sorted(Comparator.comparingLong((Integer version) -> -places.cost(object, version)))
        .toList();
  }
}
