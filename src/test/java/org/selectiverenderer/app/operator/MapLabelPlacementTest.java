package org.selectiverenderer.app.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.app.operator.MapLabelPlacement.Label;

class MapLabelPlacementTest {
  @Test
  void noNameLiesOnAnotherOrOutsideOfTheMap() {
    MapLabelPlacement labels = new MapLabelPlacement(300, 200);
    labels.add("BookcaseProx", 250, 10, 0);
    labels.add("DeskProx", 252, 12, 0);
    labels.add("WindowProx", 240, 14, 0);
    labels.add("Office", 10, 182, 0);
    labels.add("Lounge", 12, 190, 0);
    List<Label> placed = labels.placed();
    for (int i = 0; i < placed.size(); i++) {
      Label label = placed.get(i);
      assertThat(label.x() + label.width()).isLessThanOrEqualTo(300);
      assertThat(label.y()).isBetween(0.0, 200.0);
      assertThat(placed.subList(0, i)).noneMatch(label::meets);
    }
  }
}
