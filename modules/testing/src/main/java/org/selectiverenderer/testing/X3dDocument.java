package org.selectiverenderer.testing;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/** An X3D file as the JDK's own parser sees it: a judge that shares no code with our reader. */
public record X3dDocument(Path file, Document dom) {

  public static X3dDocument read(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
      factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
      // The JDK limits attribute text to a size that scenes exceed.
      factory.setAttribute("jdk.xml.maxGeneralEntitySizeLimit", "0");
      return new X3dDocument(file, factory.newDocumentBuilder().parse(in));
    } catch (ParserConfigurationException | SAXException e) {
      throw new IOException(file + " cannot be parsed: " + e.getMessage(), e);
    }
  }

  public List<Element> elements(String name) {
    NodeList found = dom.getElementsByTagName(name);
    List<Element> elements = new ArrayList<>();
    for (int i = 0; i < found.getLength(); i++) {
      elements.add((Element) found.item(i));
    }
    return elements;
  }

  public Optional<Element> def(String def) {
    return elements("*").stream().filter(e -> e.getAttribute("DEF").equals(def)).findFirst();
  }

  /** Faces of the IndexedFaceSets, all of which must be triangles. */
  public int triangles() {
    int count = 0;
    for (Element faceSet : elements("IndexedFaceSet")) {
      double[] index = numbers(faceSet.getAttribute("coordIndex"));
      for (int i = 0; i < index.length; i++) {
        if ((i % 4 == 3) != (index[i] < 0)) {
          throw new AssertionError(file + ": a face is no triangle, at index " + i);
        }
      }
      count += index.length / 4;
    }
    return count;
  }

  /** Lowest x, y, z and highest x, y, z of all Coordinates, without transformations. */
  public double[] pointBounds() {
    double[] bounds = {1e9, 1e9, 1e9, -1e9, -1e9, -1e9};
    for (Element coordinate : elements("Coordinate")) {
      double[] points = numbers(coordinate.getAttribute("point"));
      for (int i = 0; i < points.length; i++) {
        bounds[i % 3] = Math.min(bounds[i % 3], points[i]);
        bounds[3 + i % 3] = Math.max(bounds[3 + i % 3], points[i]);
      }
    }
    return bounds;
  }

  public static double[] numbers(String text) {
    return Arrays.stream(text.strip().split("[\\s,]+")).mapToDouble(Double::parseDouble).toArray();
  }
}
