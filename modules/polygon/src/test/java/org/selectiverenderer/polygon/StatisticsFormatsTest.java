package org.selectiverenderer.polygon;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

/** On a machine whose language writes numbers otherwise. */
class StatisticsFormatsTest {
  private static final SceneStatistics SCENE =
      new SceneStatistics(
          "office.x3d",
          291500,
          List.of(
              new ObjectCount("Switch_TrashCan", Optional.of("Office"), List.of(1064L, 93L), 0),
              new ObjectCount("Switch, far away", Optional.empty(), List.of(3L, 12L, 4L), 1)),
          List.of(
              new ScopeCount(
                  "Office",
                  291489,
                  List.of(
                      new StateCount(
                          List.of("OfficeSchema"),
                          67003,
                          100.0 * 67003 / 291489,
                          new RenderingCost(118, 1_398_100)),
                      new StateCount(
                          List.of("DeskSchema", "BookcaseSchema"),
                          165608,
                          100.0 * 165608 / 291489)),
                  new RenderingCost(120, 5_592_404))));

  private final Locale before = Locale.getDefault();

  @BeforeEach
  void german() {
    Locale.setDefault(Locale.GERMANY);
  }

  @AfterEach
  void asBefore() {
    Locale.setDefault(before);
  }

  @Test
  void text() {
    assertThat(SceneStatisticsTextWriter.of(SCENE))
        .isEqualTo(
            """
            office.x3d: 291,500 polygons with all objects high

            Office

              object              v1  v2
              Switch_TrashCan  1,064  93  8.74 %

              activated                      polygons
              all objects high                291,489  100.00 %
              OfficeSchema                     67,003   22.99 %
              DeskSchema and BookcaseSchema   165,608   56.81 %

            in no scope

              object            v1           v2  v3
              Switch, far away   3  25.00 %  12   4  33.33 %
            """);
  }

  @Test
  void csv() {
    assertThat(SceneStatisticsCsvWriter.of(SCENE))
        .isEqualTo(
            """
            kind,scope,name,version,polygons,percent,draw_calls,texture_bytes
            total,,office.x3d,,291500,100.00,,
            object,Office,Switch_TrashCan,1,1064,100.00,,
            object,Office,Switch_TrashCan,2,93,8.74,,
            object,,"Switch, far away",1,3,25.00,,
            object,,"Switch, far away",2,12,100.00,,
            object,,"Switch, far away",3,4,33.33,,
            high,Office,,,291489,100.00,120,5592404
            state,Office,OfficeSchema,,67003,22.99,118,1398100
            state,Office,DeskSchema+BookcaseSchema,,165608,56.81,0,0
            """);
  }

  @Test
  void json() {
    assertThat(SceneStatisticsJsonWriter.of(SCENE))
        .isEqualToNormalizingWhitespace(
            """
            { "scene" : "office.x3d", "total_high" : 291500, "objects" : [ {
            "switch" : "Switch_TrashCan", "scope" : "Office", "versions" : [ 1064, 93 ] }, {
            "switch" : "Switch, far away", "scope" : null, "versions" : [ 3, 12, 4 ] } ],
            "scopes" : [ { "scope" : "Office", "high" : 291489, "states" : [ {
            "schemas" : [ "OfficeSchema" ], "polygons" : 67003, "percent" : 22.99,
            "draw_calls" : 118, "texture_bytes" : 1398100 }, {
            "schemas" : [ "DeskSchema", "BookcaseSchema" ], "polygons" : 165608, "percent" : 56.81,
            "draw_calls" : 0, "texture_bytes" : 0 } ],
            "high_draw_calls" : 120, "high_texture_bytes" : 5592404 } ] }
            """);
  }
}
