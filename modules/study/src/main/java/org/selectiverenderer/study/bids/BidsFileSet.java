package org.selectiverenderer.study.bids;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.TableColumn;

/** The files of a dataset, held in memory by their relative paths until all of them are written. */
final class BidsFileSet {
  private final Map<String, byte[]> files = new LinkedHashMap<>();

  void add(String path, String text) {
    add(path, text.getBytes(StandardCharsets.UTF_8));
  }

  void add(String path, byte[] bytes) {
    files.put(path, bytes);
  }

  /**
   * Adds a table ({@code .tsv}) and its JSON sidecar, which explains the columns.
   *
   * @param stem path of the two files without the file name extension
   * @param more further members of the sidecar, written before the columns
   */
  void add(String stem, DataTable table, ObjectNode more) {
    add(stem + ".tsv", table.tsv());
    add(stem + ".json", sidecar(table, more));
  }

  private static String sidecar(DataTable table, ObjectNode more) {
    ObjectNode root = more.deepCopy();
    for (TableColumn column : table.columns()) {
      ObjectNode node = root.putObject(column.name()).put("Description", column.meaning());
      if (!column.unit().isEmpty()) {
        node.put("Units", column.unit());
      }
      if (!column.levels().isEmpty()) {
        ObjectNode levels = node.putObject("Levels");
        column.levels().forEach(levels::put);
      }
    }
    return JsonWriter.of(root);
  }

  int size() {
    return files.size();
  }

  /** Writes all files, or none. */
  void write(Path folder) throws IOException {
    FileTransaction writing = new FileTransaction(FileOperations.PRIVATE);
    files.forEach((name, bytes) -> writing.add(folder.resolve(name), bytes));
    writing.commit();
  }

  static ObjectNode nothing() {
    return JsonTree.object();
  }
}
