package org.selectiverenderer.enricher.cost;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Limits as people write them. */
class StatesTableModelTest {
  @Test
  void numbersAreReadAsPeopleWriteThem() {
    assertThat(StatesTableModel.number("170 000")).contains(170000L);
    assertThat(StatesTableModel.number("170,000")).contains(170000L);
    assertThat(StatesTableModel.number("170.000")).contains(170000L);
    assertThat(StatesTableModel.number("many")).isEmpty();
    assertThat(StatesTableModel.number("-5")).isEmpty();
    assertThat(StatesTableModel.number("99999999999999999999")).isEmpty();
  }
}
