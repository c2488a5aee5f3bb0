package org.selectiverenderer.enricher.overview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.enricher.robot.TestSessions;

class CellClipboardTest {
  private final EnrichmentScenes scene =
      EnrichmentScenes.with(TestSessions.object("Sink") + TestSessions.object("TrashCan"));
  private final OverviewTableModel model =
      new OverviewTableModel(scene.enrichment, making -> scene.perform(making.get()));
  private final CellClipboard clipboard = new CellClipboard(model);

  CellClipboardTest() {
    scene.document.addListener(change -> model.refresh());
    model.addSchema("A");
    model.addSchema("B");
  }

  private static List<CellPosition> all() {
    return List.of(
        new CellPosition(0, 1),
        new CellPosition(0, 2),
        new CellPosition(1, 1),
        new CellPosition(1, 2));
  }

  @Test
  void whatIsCopiedCanBePasted() {
    model.setValueAt("high", 0, 1);
    model.setValueAt("low", 1, 2);
    String text = clipboard.copy(all(), false);
    assertThat(text).isEqualTo("high\t\n\tlow\n");
    model.setValueAt("", 0, 1);
    model.put(clipboard.paste(text, List.of(new CellPosition(0, 1))));
    assertThat(clipboard.copy(all(), false)).isEqualTo(text);
  }

  @Test
  void namesSayWhereCellsGo() {
    model.put(clipboard.paste("object\tB\nTrashCan\th\n", List.of()));
    assertThat(clipboard.copy(all(), true)).isEqualTo("object\tA\tB\nSink\t\t\nTrashCan\t\thigh\n");
  }

  @Test
  void oneValueFillsTheSelection() {
    model.put(clipboard.paste("low", all()));
    assertThat(clipboard.copy(all(), false)).isEqualTo("low\tlow\nlow\tlow\n");
  }

  @Test
  void whatDoesNotFitOrIsNoDegreeIsRefusedAsAWhole() {
    assertThatThrownBy(() -> clipboard.paste("h\th\th", List.of(new CellPosition(0, 1))))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("do not fit");
    assertThatThrownBy(() -> clipboard.paste("h\tperhaps", List.of(new CellPosition(0, 1))))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("'perhaps' is not a degree");
    assertThatThrownBy(() -> clipboard.paste("object\tA\nTub\th", List.of()))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("'Tub'");
  }
}
