package org.selectiverenderer.enricher.problems;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.io.IOException;
import java.util.Locale;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.settings.Language;

class ProblemsTableTest {
  private final Locale before = Locale.getDefault(Locale.Category.DISPLAY);

  @AfterEach
  void languageOfBefore() {
    Locale.setDefault(Locale.Category.DISPLAY, before);
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void theSeverityIsReadableInEveryLanguage(Language language) throws IOException {
    language.apply();
    SceneDocument document = SceneDocument.of("a.x3d", new byte[0]);
    EventThread.edt(
        () -> {
          ProblemsTable table = new ProblemsTable(new ProblemsTableModel(document));
          table.setSize(400, 200);
          table.doLayout();
          TableColumn column = table.getColumnModel().getColumn(ProblemsTableModel.SEVERITY);
          TableCellRenderer head = table.getTableHeader().getDefaultRenderer();
          int room = column.getWidth() - table.getColumnModel().getColumnMargin();
          assertThat(room).isGreaterThanOrEqualTo(width(table, head, column.getHeaderValue()));
          for (Severity each : Severity.values()) {
            assertThat(room)
                .as(SeverityIcon.word(each))
                .isGreaterThanOrEqualTo(width(table, column.getCellRenderer(), each));
          }
        });
  }

  private static int width(ProblemsTable table, TableCellRenderer renderer, Object value) {
    Component cell = renderer.getTableCellRendererComponent(table, value, false, false, 0, 0);
    return cell.getPreferredSize().width;
  }
}
