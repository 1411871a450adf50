function result = fit_structure (w, s, triangle)
  # Steps 1 and 2 of the paper for one structure, then the free simulation and AIC, (8).
  #
  # w: window of scale_window. s: na, nb, nk and the segments of both paths. Every
  # iteration builds its regressors from the samples. triangle: reduce the regressors by
  # qr before lsqnonneg, which is not plain, but faster.
  first = 17;          # the first sample that is predicted, the same for every structure
  finest = 12;         # segments of the knots at which x is compared in (7)
  tolerance = 0.003;
  most_iterations = 30;

  n = numel (w.y);
  t = (first : n)';
  past_y = lags (w.y, t, 1 : s.na);
  basis = [w.h, w.h .* segment_shares(w.u, s.segments_a), ...
           (1 - w.h) .* segment_shares(w.u, s.segments_d)];

  a = zeros (s.na, 1);
  b = [1; zeros(s.nb - 1, 1)];
  d = 0;
  previous = [];
  for k = 1 : most_iterations
    # Slopes of both paths for the present a and b; offset and d are free.
    F = zeros (numel (t), columns (basis));
    for j = 1 : s.nb
      F += b(j) * basis(t - s.nk - j, :);
    end
    target = w.y(t) + past_y * a;
    free = [F(:, 1), ones(numel (t), 1)];
    [Q, R] = qr (free, 0);
    steps = F(:, 2:end);
    C = steps - Q * (Q' * steps);
    c = target - Q * (Q' * target);
    if (triangle)
      [~, T] = qr ([C, c], 0);
      g = lsqnonneg (T(:, 1:end-1), T(:, end));
    else
      g = lsqnonneg (C, c);
    end
    offset = (R \ (Q' * (target - steps * g)))(1);
    x = basis * [offset; g];

    # Process for the present x.
    theta = [-past_y, lags(x, t, s.nk + (1 : s.nb)), ones(numel (t), 1)] \ w.y(t);
    a = theta(1 : s.na);
    b = theta(s.na + (1 : s.nb));
    d = theta(end);

    # Equation (6); x takes the scale.
    scale = norm (b);
    if (sum (b) < 0)
      scale = -scale;
    end
    b /= scale;
    x *= scale;
    g *= scale;
    offset *= scale;

    # Equation (7), with x at the finest knots in place of the slopes.
    x_a = offset + [0; cumsum(g(1 : s.segments_a))];
    x_d = [0; cumsum(g(s.segments_a + 1 : end))];
    knots = (0 : finest)' / finest;
    now = [a; b; d; interp1((0 : s.segments_a)' / s.segments_a, x_a, knots); ...
           interp1((0 : s.segments_d)' / s.segments_d, x_d, knots)];
    if (k > 1 && norm (now - previous) < tolerance * norm (now))
      break;
    end
    previous = now;
  end

  result = struct ("known", all (abs (roots ([1; a])) < 1 - 1e-6), "aic", NaN, "fit", NaN);
  if (! result.known)
    return;
  end
  # Free simulation from the first measured outputs; x was constant before the window.
  input = d + lags_held (x, s.nk + (1 : s.nb)) * b;
  input(1 : s.na) = filter ([1; a], 1, w.y(1 : s.na));
  simulated = filter (1, [1; a], input);
  error_sum = sumsq (w.y - simulated);
  dimension = s.na + s.nb + 1 + s.segments_a + s.segments_d + 2;
  result.aic = n * log (error_sum) + 2 * dimension;
  result.fit = 100 * (1 - norm (w.y - simulated) / norm (w.y - mean (w.y)));
end

function m = lags (v, t, which)
  m = reshape (v(t - which), numel (t), numel (which));
end

function m = lags_held (v, which)
  m = v(max ((1 : numel (v))' - which, 1));
end

# Share of each of `count` equal segments of 0 ... 1 that lies below u.
function m = segment_shares (u, count)
  m = min (max (u * count - (0 : count - 1), 0), 1);
end
