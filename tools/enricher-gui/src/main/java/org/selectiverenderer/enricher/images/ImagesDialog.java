package org.selectiverenderer.enricher.images;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Window;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.images.ImageReference;
import org.selectiverenderer.authoring.images.ImageSearch;
import org.selectiverenderer.authoring.images.ImageUrlEdit;
import org.selectiverenderer.enricher.component.ColumnHeads;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.task.TaskProgress;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * The dialog that lists the images that the scene names, with their sizes in pixels and bytes;
 * missing ones are looked for in a folder, and the scene names what is found in one undo step.
 */
@SuppressWarnings("serial") // never written
public final class ImagesDialog extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final int SIDE = 48;

  private final EnricherSession session;
  private final ImagesTableModel model = new ImagesTableModel();
  private final JTable table = new JTable(model);
  private final JLabel state = PlainText.only(new JLabel(" "));
  private final JButton find = Mnemonics.button("images.find");
  private final JButton show = Mnemonics.button("images.show");
  private final DocumentListener changes = change -> read();
  private @Nullable BackgroundTask running;

  /** Creates the dialog, which reads the images at once. */
  public ImagesDialog(Window owner, EnricherSession session) {
    super(owner, Texts.of("images.title"), ModalityType.DOCUMENT_MODAL);
    this.session = session;
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(new MigLayout("insets dialog, fill", "[grow,fill]", "[grow,fill][][]"));
    content.add(table(), "grow, wrap");
    content.add(state, "wmin 0, wrap");
    content.add(buttons());
    state.getAccessibleContext().setAccessibleName(Texts.of("images.state"));
    setContentPane(content);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    session.document().addListener(changes);
    WindowPacker.pack(this);
    setLocationRelativeTo(owner);
    read();
  }

  private JScrollPane table() {
    PlainText.cells(table);
    table.getAccessibleContext().setAccessibleName(Texts.of("images.table"));
    table.setFillsViewportHeight(true);
    table.setRowHeight(UIScale.scale(SIDE + 4));
    table.setAutoCreateRowSorter(true);
    table.getTableHeader().setReorderingAllowed(false);
    table.getSelectionModel().setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.getSelectionModel().addListSelectionListener(e -> refresh());
    int[] widths = {60, 260, 100, 80, 80, 60, 280};
    for (int i = 0; i < widths.length; i++) {
      table.getColumnModel().getColumn(i).setPreferredWidth(UIScale.scale(widths[i]));
    }
    ColumnHeads.fit(table);
    JScrollPane pane = new JScrollPane(table);
    pane.setPreferredSize(new Dimension(UIScale.scale(920), UIScale.scale(380)));
    return pane;
  }

  private JPanel buttons() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "[][]push[]"));
    find.setToolTipText(Texts.of("images.findtip"));
    find.addActionListener(e -> chooseFolder());
    show.addActionListener(e -> showNode());
    JButton close = new JButton(Texts.of("images.close"));
    close.addActionListener(e -> dispose());
    panel.add(find);
    panel.add(show);
    panel.add(close, "tag ok");
    return panel;
  }

  private Path folder() {
    return session.file().path().toAbsolutePath().resolveSibling("").normalize();
  }

  /** Reads all images in the background. */
  private void read() {
    stop();
    Map<List<String>, List<ImageReference>> grouped = new LinkedHashMap<>();
    for (ImageReference reference : ImageReference.in(session.document())) {
      grouped.computeIfAbsent(reference.urls(), urls -> new ArrayList<>()).add(reference);
    }
    List<List<String>> names = List.copyOf(grouped.keySet());
    Path folder = folder();
    int side = UIScale.scale(SIDE);
    state.setText(Texts.of("images.reading"));
    running =
        session
            .tasks()
            .run(
                Texts.of("images.reading"),
                progress -> inspect(names, folder, side, progress),
                images -> {
                  running = null;
                  List<ImagesTableModel.Row> rows = new ArrayList<>();
                  grouped.forEach(
                      (urls, uses) ->
                          rows.add(
                              new ImagesTableModel.Row(
                                  List.copyOf(uses), images.get(names.indexOf(urls)))));
                  rows.sort(Comparator.comparing(row -> row.image().readable()));
                  model.rows(rows);
                  refresh();
                },
                this::failed);
    refresh();
  }

  private List<InspectedImage> inspect(
      List<List<String>> names, Path folder, int side, TaskProgress progress) {
    UrlResolver resolver = new UrlResolver(folder, session.access());
    List<InspectedImage> images = new ArrayList<>();
    for (List<String> urls : names) {
      progress.check();
      progress.done((double) images.size() / names.size());
      images.add(InspectedImage.of(urls, resolver, folder, side));
    }
    return images;
  }

  private void failed(Exception failure) {
    running = null;
    refresh();
    state.setText(String.valueOf(failure.getMessage()));
  }

  private void refresh() {
    List<ImagesTableModel.Row> rows = model.rows();
    long missing = rows.stream().filter(row -> row.image().missing()).count();
    find.setEnabled(running == null && missing > 0 && session.document().locked().isEmpty());
    show.setEnabled(chosen().isPresent());
    if (running == null) {
      state.setText(
          Texts.of(
              "images.total",
              rows.size(),
              String.valueOf(rows.size()),
              ByteFormat.of(rows.stream().mapToLong(row -> row.image().bytes()).sum()),
              ByteFormat.of(rows.stream().mapToLong(row -> row.image().cardBytes()).sum()),
              String.valueOf(missing)));
    }
  }

  private Optional<ImagesTableModel.Row> chosen() {
    int row = table.getSelectedRow();
    return row < 0 ? Optional.empty() : Optional.of(model.row(table.convertRowIndexToModel(row)));
  }

  private void showNode() {
    chosen()
        .map(row -> row.uses().get(0).element())
        .ifPresent(
            element -> {
              session.select(element, this);
              dispose();
            });
  }

  private void chooseFolder() {
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setCurrentDirectory(folder().toFile());
    chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
    chooser.setDialogTitle(Texts.of("images.folder"));
    if (chooser.showDialog(this, Texts.of("images.look")) == JFileChooser.APPROVE_OPTION) {
      find(chooser.getSelectedFile().toPath());
    }
  }

  /** Looks for the missing images in a folder and has the scene name those that are found. */
  void find(Path where) {
    stop();
    Map<ImageReference, String> missing = missing();
    Set<String> names = Set.copyOf(missing.values());
    long revision = session.document().revision();
    state.setText(Texts.of("images.looking"));
    running =
        session
            .tasks()
            .run(
                Texts.of("images.looking"),
                progress -> look(where, names, progress),
                found -> {
                  running = null;
                  if (revision == session.document().revision()) {
                    name(missing, found);
                  }
                },
                this::failed);
    find.setEnabled(false);
  }

  /** Returns the references to missing images with the names of their files. */
  private Map<ImageReference, String> missing() {
    Map<ImageReference, String> missing = new LinkedHashMap<>();
    for (ImagesTableModel.Row row : model.rows()) {
      if (row.image().missing()) {
        row.urls().stream()
            .flatMap(url -> ImageReference.fileName(url).stream())
            .findFirst()
            .ifPresent(name -> row.uses().forEach(use -> missing.put(use, name)));
      }
    }
    return missing;
  }

  private Map<String, Path> look(Path where, Set<String> names, TaskProgress progress)
      throws IOException {
    Map<String, Path> found = new HashMap<>(ImageSearch.find(where, names, progress::cancelled));
    UrlResolver resolver = new UrlResolver(folder(), session.access());
    found.values().removeIf(file -> !resolver.mayBeNamed(file)); // it would stay missing
    return found;
  }

  private void name(Map<ImageReference, String> missing, Map<String, Path> found) {
    Map<ImageReference, Path> files = new LinkedHashMap<>();
    missing.forEach(
        (reference, name) -> {
          Path file = found.get(name);
          if (file != null) {
            files.put(reference, file);
          }
        });
    refresh();
    if (files.isEmpty()) {
      state.setText(Texts.of("images.notfound"));
      return;
    }
    session.attempt(
        () -> session.document().perform(ImageUrlEdit.of(session.document(), files, folder())));
  }

  private void stop() {
    if (running != null) {
      running.cancel();
      running = null;
    }
  }

  @Override
  public void dispose() {
    stop();
    session.document().removeListener(changes);
    super.dispose();
  }
}
