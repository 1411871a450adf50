# The structure search written plainly: octave-cli peer.m FOLDER.
#
# FOLDER holds window.csv (columns t, u, y) and structures.csv (na, nb, nk, segments of
# both paths, known, AIC, fit: what stickband_bench found). Prints one line for each way of
# solving, plain and triangle (see fit_structure):
#   way structures cpu_s largest_aic_difference largest_fit_difference disagreements
# cpu_s is the least processor time of several runs over the whole list.
1;

repetitions = 3;
folder = argv (){end};
window = dlmread (fullfile (folder, "window.csv"), ",", 1, 0);
list = dlmread (fullfile (folder, "structures.csv"), ",", 1, 0);
ways = {"plain", "triangle"};
for way = 1 : 2
  least = Inf;
  for repetition = 1 : repetitions
    disagreements = 0;
    found = NaN (rows (list), 2);
    start = cputime ();
    w = scale_window (window(:, 2), window(:, 3));
    for k = 1 : rows (list)
      s = struct ("na", list(k, 1), "nb", list(k, 2), "nk", list(k, 3), ...
                  "segments_a", list(k, 4), "segments_d", list(k, 5));
      result = fit_structure (w, s, way == 2);
      found(k, :) = [result.aic, result.fit];
      disagreements += result.known != list(k, 6);
    end
    least = min (least, cputime () - start);
  end
  difference = max (abs (found - list(:, 7:8)));
  printf ("%s %d %.4f %.2g %.2g %d\n", ways{way}, rows (list), least, ...
          difference(1), difference(2), disagreements);
end
