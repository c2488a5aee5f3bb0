package org.selectiverenderer.study.design;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WilliamsSquareTest {
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 4, 5, 6, 7})
  void eachTreatmentIsAtEachPlaceAndAfterEachOtherEquallyOften(int size) {
    int rows = WilliamsSquare.rows(size);
    Map<List<Integer>, Integer> places = new HashMap<>();
    Map<List<Integer>, Integer> pairs = new HashMap<>();
    for (int turn = 0; turn < rows; turn++) {
      List<Integer> row = WilliamsSquare.row(size, turn);
      assertThat(row).hasSize(size).doesNotHaveDuplicates();
      for (int at = 0; at < size; at++) {
        places.merge(List.of(at, row.get(at)), 1, Integer::sum);
        if (at > 0) {
          pairs.merge(List.of(row.get(at - 1), row.get(at)), 1, Integer::sum);
        }
      }
    }
    assertThat(places).hasSize(size * size);
    assertThat(places.values()).containsOnly(rows / size);
    assertThat(pairs).hasSize(size * (size - 1));
    assertThat(pairs.values()).containsOnly(rows / size);
    assertThat(WilliamsSquare.row(size, rows)).isEqualTo(WilliamsSquare.row(size, 0));
  }
}
